//! The macros of the crate `fixel` that put models and pictures into flash. Use them through `fixel`, which documents
//! them.

mod arguments;
mod expansion;
mod mesh;
mod picture;
#[cfg(test)]
mod tests;

use std::path::Path;

use arguments::Arguments;
use base64::prelude::{BASE64_STANDARD, Engine};
use proc_macro::{Delimiter, Group, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

/// Expands one of `fixel`'s macros. The input is the macro's name, the path of `fixel`, and the macro's own input.
#[proc_macro]
pub fn assets(input: TokenStream) -> TokenStream {
    let mut input = input.into_iter();
    let (name, fixel) = (input.next(), input.next());
    let (Some(name), Some(fixel)) = (name, fixel) else {
        return error("use this macro through the crate fixel", Span::call_site());
    };
    let mut span = Span::call_site();
    let expanded = Arguments::parse(input.collect(), &mut span).and_then(|arguments| {
        let expansion = match name.to_string().as_str() {
            "mesh" => mesh::mesh(&arguments),
            "materials" => mesh::materials(&arguments),
            "outline" => mesh::outline(&arguments),
            _ => picture::texture(&arguments),
        };
        Ok(expansion
            .map_err(|problem| format!("{}: {problem}", arguments.path.value))?
            .tokens(&fixel, span))
    });
    expanded.unwrap_or_else(|problem| error(&problem, span))
}

/// A picture of `fixel`'s own documentation as a `data:` URI. The picture is part of the page because docs.rs serves no
/// other files. The input is string literals, which together are the picture's path in the folder `pictures` of this
/// package.
#[doc(hidden)]
#[proc_macro]
pub fn picture_uri(input: TokenStream) -> TokenStream {
    let input = input.to_string();
    let parts = input.split('"').skip(1).step_by(2);
    let folder = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/pictures"));
    let path = folder.join(parts.collect::<String>());
    match std::fs::read(&path) {
        Ok(picture) => {
            let uri = format!("data:image/png;base64,{}", BASE64_STANDARD.encode(picture));
            TokenTree::Literal(Literal::string(&uri)).into()
        }
        Err(problem) => error(&format!("{}: {problem}", path.display()), Span::call_site()),
    }
}

/// Expands to a compiler error with this message.
fn error(problem: &str, span: Span) -> TokenStream {
    let mut message = Literal::string(problem);
    message.set_span(span);
    let mut bang = Punct::new('!', Spacing::Alone);
    bang.set_span(span);
    let tokens = TokenStream::from(TokenTree::Literal(message));
    let mut group = Group::new(Delimiter::Brace, tokens);
    group.set_span(span);
    let path = "::core::compile_error"
        .parse::<TokenStream>()
        .unwrap_or_default();
    let path = path.into_iter().map(|mut token| {
        token.set_span(span);
        token
    });
    let path = path.chain([TokenTree::Punct(bang), TokenTree::Group(group)]);
    path.collect()
}

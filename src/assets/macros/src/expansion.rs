//! The statics that a macro expands to.

use std::path::{Path, PathBuf};

use fixel_assets::Notes;
use proc_macro::{Group, Literal, Span, TokenStream, TokenTree};

/// The source text of a block. Some of its words are placeholders for other tokens.
#[derive(Default)]
pub struct Expansion {
    text: String,
    lists: Vec<Vec<u8>>,
    notes: Vec<String>,
}

impl Expansion {
    /// Adds Rust source. The word `fixel` in it is a placeholder for the path of the crate.
    pub fn push(&mut self, text: &str) {
        self.text.push_str(text);
        self.text.push('\n');
    }

    /// Stores a list of bytes. Returns the placeholder for the list.
    pub fn bytes(&mut self, bytes: Vec<u8>) -> String {
        self.lists.push(bytes);
        format!("list_{}", self.lists.len() - 1)
    }

    /// Makes the compiler expand the macro again when one of these files changes.
    pub fn depend(&mut self, files: &[PathBuf]) {
        for file in files.iter().filter(|file| file.is_file()) {
            let file = std::path::absolute(file).unwrap_or_else(|_| file.clone());
            self.push(&format!(
                "const _: &[u8] = ::core::include_bytes!({:?});",
                display(&file)
            ));
        }
    }

    /// Makes the compiler warn about everything that was replaced or left out when the file was read.
    pub fn note(&mut self, path: &str, notes: &Notes) {
        let notes = notes.iter().map(|note| format!("{path}: {note}"));
        self.notes.extend(notes);
    }

    /// The notes that become warnings.
    #[cfg(test)]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// The tokens of the block. The compiler reports errors in these tokens at `span`.
    pub fn tokens(mut self, fixel: &TokenTree, span: Span) -> TokenStream {
        let notes = std::mem::take(&mut self.notes);
        for note in notes {
            // A procedural macro can cause a warning only by using a deprecated item.
            self.text.insert_str(
                0,
                &format!("const _: () = {{ #[deprecated(note = {note:?})] const ASSET: () = (); ASSET }};\n"),
            );
        }
        let text = format!("{{ {} }}", self.text);
        let tokens: TokenStream = text.parse().unwrap_or_default();
        self.replaced(tokens, fixel, span)
    }

    fn replaced(&self, tokens: TokenStream, fixel: &TokenTree, span: Span) -> TokenStream {
        let replace = |token: TokenTree| -> TokenTree {
            let mut token = match token {
                TokenTree::Ident(word) => {
                    let word_text = word.to_string();
                    let list = word_text
                        .strip_prefix("list_")
                        .and_then(|at| at.parse::<usize>().ok());
                    match list.and_then(|at| self.lists.get(at)) {
                        Some(bytes) => TokenTree::Literal(Literal::byte_string(bytes)),
                        None if word_text == "fixel" => return fixel.clone(),
                        None => TokenTree::Ident(word),
                    }
                }
                TokenTree::Group(group) => {
                    let tokens = self.replaced(group.stream(), fixel, span);
                    TokenTree::Group(Group::new(group.delimiter(), tokens))
                }
                token => token,
            };
            token.set_span(span.resolved_at(Span::mixed_site()));
            token
        };
        tokens.into_iter().map(replace).collect()
    }
}

fn display(path: &Path) -> String {
    path.to_string_lossy().into_owned()
}

//! Parses a macro's arguments: the path of a file, and options.

use std::path::{Path, PathBuf};

use proc_macro::{Delimiter, Literal, Span, TokenStream, TokenTree};

/// A file that the program names.
pub struct Asset {
    /// The path in the program's text.
    pub value: String,
    /// The path of the same file, resolved from the folder of the source file.
    pub path: PathBuf,
}

/// The input of a macro.
pub struct Arguments {
    pub path: Asset,
    /// Options without a value, such as `center`, and options with a value, such as `scale = 0.01`.
    options: Vec<(String, Option<String>)>,
}

impl Arguments {
    /// Parses the tokens. Sets `span` to the span of the path or, after an error, to the span of the error.
    pub fn parse(input: TokenStream, span: &mut Span) -> Result<Self, String> {
        let mut parts = split(input).into_iter();
        let first = parts.next().unwrap_or_default();
        if let Some(token) = first.first() {
            *span = token.span();
        }
        let [token] = first.as_slice() else {
            return Err("it needs the path of a file, in quotation marks".into());
        };
        let value = string(&token.to_string())
            .ok_or("the path of the file must be a text in quotation marks")?;
        let path = beside_source(*span, &value);
        let mut options = Vec::new();
        for part in parts {
            let words: Vec<String> = part.iter().map(ToString::to_string).collect();
            let option = match words.as_slice() {
                [] => continue,
                [word] => (word.clone(), None),
                [word, equals, value @ ..] if equals == "=" && !value.is_empty() => {
                    (word.clone(), Some(value.concat()))
                }
                _ => return Err(format!("'{}' is not an option", words.concat())),
            };
            options.push(option);
        }
        let path = Asset { value, path };
        Ok(Self { path, options })
    }

    /// Arguments of a test: the path of a file, and options without values.
    #[cfg(test)]
    pub fn of(path: &Path, options: &[&str]) -> Self {
        let value = path.display().to_string();
        let options = options.iter().map(|word| ((*word).into(), None)).collect();
        Self {
            path: Asset {
                value,
                path: path.into(),
            },
            options,
        }
    }

    /// Refuses options that are not in `known`.
    pub fn check(&self, known: &[&str]) -> Result<(), String> {
        match self
            .options
            .iter()
            .find(|(word, _)| !known.contains(&word.as_str()))
        {
            Some((word, _)) => Err(format!(
                "'{word}' is not an option: the options are {}",
                known.join(", ")
            )),
            None => Ok(()),
        }
    }

    /// Whether the option `word` is given without a value.
    pub fn has(&self, word: &str) -> bool {
        self.options
            .iter()
            .any(|(option, value)| option == word && value.is_none())
    }

    /// The value of an option.
    pub fn value(&self, word: &str) -> Option<&str> {
        let option = self.options.iter().find(|(option, _)| option == word);
        option.and_then(|(_, value)| value.as_deref())
    }

    /// The value of an option, which must be a string.
    pub fn text(&self, word: &str) -> Result<Option<String>, String> {
        let value = self.value(word).map(|value| {
            string(value).ok_or_else(|| format!("{word} must be a text in quotation marks"))
        });
        value.transpose()
    }

    /// The value of an option, which must be a number.
    pub fn number(&self, word: &str) -> Result<Option<f64>, String> {
        let value = self.value(word).map(|value| {
            let number = value.replace('_', "").parse::<f64>().ok();
            number
                .filter(|number| number.is_finite())
                .ok_or_else(|| format!("{word} is {value}: it must be a number"))
        });
        value.transpose()
    }
}

/// Splits the tokens at commas. Tokens that another macro has passed on come in groups without delimiters.
fn split(input: TokenStream) -> Vec<Vec<TokenTree>> {
    let mut parts = vec![Vec::new()];
    let mut push = |token: TokenTree| match (&token, parts.last_mut()) {
        (TokenTree::Punct(comma), _) if comma.as_char() == ',' => parts.push(Vec::new()),
        (_, Some(part)) => part.push(token),
        (_, None) => {}
    };
    for token in input {
        match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => {
                group.stream().into_iter().for_each(&mut push);
            }
            token => push(token),
        }
    }
    parts
}

/// The value of a string literal.
fn string(literal: &str) -> Option<String> {
    let literal: Literal = literal.parse().ok()?;
    let text = literal.to_string();
    if let Some(raw) = text.strip_prefix('r') {
        let raw = raw.trim_matches('#');
        return Some(raw.strip_prefix('"')?.strip_suffix('"')?.into());
    }
    let inner = text.strip_prefix('"')?.strip_suffix('"')?;
    // These are the escapes that a path can need.
    let mut value = String::new();
    let mut letters = inner.chars();
    while let Some(letter) = letters.next() {
        value.push(match letter {
            '\\' => match letters.next()? {
                escaped @ ('\\' | '"' | '\'') => escaped,
                _ => return None,
            },
            letter => letter,
        });
    }
    Some(value)
}

/// Resolves a path from the folder of the span's source file. If that file is unknown, as in some editors, the path is
/// relative to the package.
fn beside_source(span: Span, path: &str) -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR").map(PathBuf::from);
    let source = span.local_file().or_else(|| {
        // In a documentation test, the span names the file that contains the test.
        Some(package.as_deref()?.join(span.file())).filter(|source| source.is_file())
    });
    let folder = source
        .as_deref()
        .and_then(Path::parent)
        .map(Path::to_path_buf);
    let path = folder.or(package).unwrap_or_default().join(path);
    std::path::absolute(&path).unwrap_or(path)
}

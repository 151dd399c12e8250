//! `demeter info`.

use crate::arguments::InfoArguments;
use crate::exit::Exit;
use crate::failure::Failure;

/// Tells what is in a file.
pub fn info(arguments: &InfoArguments) -> Result<Exit, Failure> {
    Err(Failure::wrong(format!("`{}` is not known", arguments.file.display())))
}

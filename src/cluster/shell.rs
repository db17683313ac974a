//! POSIX shell text: quoted words, and running one part so that a signal reaches it.
//!
//! A shell waits for a command in the foreground before it runs a trap, so the part runs in the
//! background. `wait` ends early when a trap has run; the shell remembers the exit code of the
//! part all the same and gives it to the next `wait` (POSIX.1-2017, XCU 2.11 and `wait`).

/// A word that the shell takes for exactly this text.
pub fn quote(text: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-+,:@".contains(c);
    if !text.is_empty() && text.chars().all(plain) {
        return text.into();
    }
    format!("'{}'", text.replace('\'', r"'\''"))
}

/// A shell function that runs a command, passes SIGTERM on to it, and leaves its exit code in
/// `code`.
///
/// Some schedulers signal only the script, some every process of the job. In the second case the
/// command must not get the signal twice: the second one ends it without a checkpoint. So the
/// script waits a second before it passes the signal on; then it reaches nobody.
pub(super) const ATTEND: &str = r#"# Runs a command, passes SIGTERM on to it, leaves its exit code in $code.
attend() {
    stopped=''
    trap 'stopped=1; sleep 1; kill -TERM "$!" 2>/dev/null' TERM
    "$@" &
    # A signal ends wait early; the exit code comes with the next one (127: it was known already).
    code=127
    while :; do
        stopped=''
        wait "$!"
        status=$?
        [ "$status" -eq 127 ] || code=$status
        [ -n "$stopped" ] || break
    done
}
"#;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words() {
        for plain in ["plan.json", "/a/b-c_d.e", "tilepack", "12:00:00"] {
            assert_eq!(quote(plain), plain);
        }
        for (text, word) in [
            ("", "''"),
            ("a b", "'a b'"),
            ("it's", r"'it'\''s'"),
            ("$HOME", "'$HOME'"),
            ("~", "'~'"),
            ("a=b", "'a=b'"),
            ("é", "'é'"),
            ("a\nb", "'a\nb'"),
        ] {
            assert_eq!(quote(text), word);
        }
    }
}

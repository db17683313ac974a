//! Opening and writing files.

use std::fs;
use std::io::Write;
use std::path::Path;
use tilepack::store::{AtomicFile, Input, MAX_BYTES, StoreError, check_writable, write_file};

#[test]
fn files_that_are_no_text_files() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |name: &str| {
        let path = folder.path().join(name);
        let error = Input::open(&path).unwrap_err();
        assert_eq!(error.file(), path);
        let message = error.to_string();
        message.strip_prefix(&format!("{}: ", path.display())).unwrap().to_owned()
    };
    fs::create_dir(folder.path().join("folder")).unwrap();
    assert_eq!(refused("folder"), "is a directory, expected a file");
    assert_eq!(refused("none.json"), "no such file");
    fs::write(folder.path().join("image.png"), b"\x89PNG\r\n\x1a\n\0\0").unwrap();
    let binary = "is a binary file: the byte at offset 0 is not UTF-8 text";
    assert_eq!(refused("image.png"), binary);
    fs::write(folder.path().join("file"), "").unwrap();
    assert!(refused("file/below").starts_with("cannot be read: "));
    let large = fs::File::create(folder.path().join("large.txt")).unwrap();
    large.set_len(MAX_BYTES + 1).unwrap();
    assert_eq!(refused("large.txt"), "is larger than 1024 MiB, the limit");
}

#[test]
fn files_appear_whole_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("out.txt");
    let names = || fs::read_dir(folder.path()).unwrap().count();
    let mut file = AtomicFile::create(&path).unwrap();
    file.write_all(b"half").unwrap();
    file.flush().unwrap();
    assert!(!path.exists());
    drop(file);
    assert_eq!(names(), 0);

    check_writable(&path).unwrap();
    assert_eq!(names(), 0);
    write_file(&path, |out| out.write_all(b"whole")).unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"whole");
    let failed = write_file(&path, |out| {
        out.write_all(b"another")?;
        Err(std::io::Error::other("the pen broke"))
    });
    let message = failed.unwrap_err().to_string();
    assert_eq!(message, format!("{}: cannot be written: the pen broke", path.display()));
    assert_eq!(fs::read(&path).unwrap(), b"whole");
    write_file(&path, |out| out.write_all(b"again")).unwrap();
    assert_eq!((fs::read(&path).unwrap(), names()), (b"again".to_vec(), 1));
}

#[cfg(unix)]
#[test]
fn permissions_and_links_are_kept() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = tempfile::tempdir().unwrap();
    let (path, link) = (folder.path().join("out.txt"), folder.path().join("link.txt"));
    fs::write(&path, "old").unwrap();
    fs::set_permissions(&path, PermissionsExt::from_mode(0o640)).unwrap();
    symlink(&path, &link).unwrap();
    write_file(&link, |out| out.write_all(b"new")).unwrap();
    assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    assert_eq!(fs::read(&path).unwrap(), b"new");
    assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
    write_file("/dev/null", |out| out.write_all(b"gone")).unwrap();
    assert!(!fs::metadata("/dev/null").unwrap().is_file());
}

#[test]
fn what_cannot_be_written_is_found_out_before() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    let refused = |path: &Path| {
        let error = check_writable(path).unwrap_err();
        assert!(matches!(error, StoreError::Unwritable { .. }));
        assert_eq!(AtomicFile::create(path).unwrap_err().to_string(), error.to_string());
        let prefix = format!("{}: cannot be written: ", path.display());
        error.to_string().strip_prefix(&prefix).unwrap().to_owned()
    };
    assert_eq!(refused(folder.path()), "it is a directory");
    let missing = format!("there is no directory {}", at("none").display());
    assert_eq!(refused(&at("none/out.txt")), missing);
    assert_eq!(refused(&at("out.txt/")), "it names a directory");
    fs::write(at("old.txt"), "old").unwrap();
    let mut permissions = fs::metadata(at("old.txt")).unwrap().permissions();
    permissions.set_readonly(true);
    fs::set_permissions(at("old.txt"), permissions).unwrap();
    assert_eq!(refused(&at("old.txt")), "the file is read-only");
    // Not even the superuser can make a file here.
    #[cfg(target_os = "linux")]
    assert!(refused(Path::new("/proc/out.txt")).starts_with("no file can be made in /proc: "));
}

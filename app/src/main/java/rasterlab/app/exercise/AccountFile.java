package rasterlab.app.exercise;

import java.io.IOException;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.FileAttribute;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import java.util.Properties;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.outcome.FileKind;
import rasterlab.app.outcome.FileToRead;
import rasterlab.app.outcome.WholeFile;
import rasterlab.app.server.Account;

/** The account of the last course joined, in a file that only its owner may read. */
final class AccountFile {
    private final Path file;

    AccountFile(Path folder) {
        file = folder.resolve("grader.properties");
    }

    /**
     * The account; empty where there is none.
     *
     * @throws IOException if the file cannot be read or holds something else
     */
    Optional<Account> load() throws IOException {
        if (!Files.exists(file)) return Optional.empty();
        Optional<String> obstacle = FileToRead.obstacle(file, FileKind.SETTINGS);
        if (obstacle.isPresent()) throw new IOException(file + ": " + obstacle.get());
        var kept = new Properties();
        try {
            kept.load(new StringReader(Files.readString(file)));
            String token = kept.getProperty("token", "");
            if (token.isEmpty()) throw new IOException(file + ": 'token' is missing");
            return Optional.of(
                    new Account(
                            Account.server(kept.getProperty("server", "")),
                            token,
                            kept.getProperty("student", "")));
        } catch (IllegalArgumentException e) {
            throw new IOException(
                    file + ": 'server' is not an http address: '" + e.getMessage() + "'", e);
        }
    }

    /** Saves the account; answers with the reason where it cannot be saved. */
    Optional<Notice> unsaved(Account account) {
        try {
            save(account);
            return Optional.empty();
        } catch (IOException e) {
            String why = file.getParent() + ": " + WholeFile.reason(e);
            return Optional.of(Notice.of("account.unsaved", account.toString(), why));
        }
    }

    /** Writes the file whole, or not at all. */
    void save(Account account) throws IOException {
        var kept = new Properties();
        kept.setProperty("server", account.server().toString());
        kept.setProperty("token", account.token());
        kept.setProperty("student", account.student());
        var text = new StringWriter();
        kept.store(text, null);
        Files.createDirectories(file.getParent());
        Path unfinished = file.resolveSibling("." + file.getFileName() + ".part");
        Files.deleteIfExists(unfinished);
        Files.createFile(unfinished, forItsOwner(file.getParent()));
        Files.write(
                unfinished,
                text.toString().getBytes(StandardCharsets.UTF_8),
                StandardOpenOption.TRUNCATE_EXISTING);
        Files.move(unfinished, file, StandardCopyOption.ATOMIC_MOVE);
    }

    private static FileAttribute<?>[] forItsOwner(Path folder) throws IOException {
        if (!Files.getFileStore(folder).supportsFileAttributeView("posix"))
            return new FileAttribute<?>[0];
        return new FileAttribute<?>[] {
            PosixFilePermissions.asFileAttribute(PosixFilePermissions.fromString("rw-------"))
        };
    }
}

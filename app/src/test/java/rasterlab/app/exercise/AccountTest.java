package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.outcome.Pipe;
import rasterlab.app.server.Account;

class AccountTest {
    @TempDir Path folder;

    @ParameterizedTest(name = "an address that is right is refused: {0}")
    @CsvSource({
        "localhost:8080, http://localhost:8080",
        " http://10.0.0.1:80/ , http://10.0.0.1:80",
        "https://example.org/grader//, https://example.org/grader"
    })
    void understandsAddresses(String typed, String meant) {
        assertEquals(URI.create(meant), Account.server(typed));
    }

    @ParameterizedTest(name = "an address that is none is taken: {0}")
    @ValueSource(
            strings = {"", "ftp://example.org", "http://", "a b", "http://h/?q=1", "file:///x"})
    void refusesWhatIsNone(String typed) {
        assertThrows(IllegalArgumentException.class, () -> Account.server(typed));
    }

    @Test
    void pipeIsNotWaitedFor() throws Exception {
        Path pipe = Pipe.at(folder.resolve("grader.properties"));
        var refusal = assertThrows(IOException.class, () -> new AccountFile(folder).load());
        assertEquals(
                pipe + ": is a device, pipe or socket, not a settings file", refusal.getMessage());
    }

    @Test
    void isThereAgain() throws IOException {
        var account = new Account(URI.create("http://localhost:8080"), "tö=ken", "Анна");
        new AccountFile(folder).save(account);
        assertEquals(Optional.of(account), new AccountFile(folder).load());
    }

    @Test
    void isReadByItsOwnerOnly() throws IOException {
        assumeTrue(
                Files.getFileStore(folder).supportsFileAttributeView("posix"), "no POSIX rights");
        new AccountFile(folder).save(new Account(URI.create("http://localhost"), "t", ""));
        new AccountFile(folder).save(new Account(URI.create("http://localhost"), "u", ""));
        assertEquals(
                "rw-------",
                PosixFilePermissions.toString(
                        Files.getPosixFilePermissions(folder.resolve("grader.properties"))));
    }

    @Test
    void brokenFileIsNamed() throws IOException {
        Files.writeString(folder.resolve("grader.properties"), "server=ftp\\://x\ntoken=t\n");
        IOException broken = assertThrows(IOException.class, () -> new AccountFile(folder).load());
        assertTrue(broken.getMessage().contains("grader.properties"), broken.getMessage());
    }

    @Test
    void tokenIsNotPrinted() {
        var account = new Account(URI.create("http://localhost"), "secret", "");
        assertFalse(account.toString().contains("secret"), account.toString());
    }
}

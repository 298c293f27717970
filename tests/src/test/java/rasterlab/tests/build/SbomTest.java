package rasterlab.tests.build;

import static java.util.stream.Collectors.toCollection;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.HexFormat;
import java.util.TreeSet;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

/** Compares the server's bill of materials with the libraries that stand beside it. */
class SbomTest {
    private static final Path TARGET = Repository.root().resolve("grader/target");
    private static final Path BILL = TARGET.resolve("sbom.json");
    private static final Path LIBRARIES = TARGET.resolve("lib");

    /** Both are made by Maven's phase package; where tests alone run, there may be none. */
    @BeforeEach
    void needsAPackagedServer() {
        assumeTrue(Files.exists(BILL) && Files.exists(LIBRARIES), "the server is not packaged");
    }

    @Test
    @DisplayName("the bill leaves out a library of the server, or names one of the tests")
    void namesWhatTheServerRunsWith() throws IOException {
        try (Stream<Path> files = Files.list(LIBRARIES)) {
            var there =
                    files.map(file -> file.getFileName().toString())
                            .collect(toCollection(TreeSet::new));
            assertFalse(there.isEmpty());
            assertEquals(
                    there, components().map(SbomTest::file).collect(toCollection(TreeSet::new)));
        }
    }

    @Test
    @DisplayName("a hash of the bill is that of another file")
    void hashesAreThoseOfTheFiles() throws Exception {
        var sha256 = MessageDigest.getInstance("SHA-256");
        for (var component : components().toList()) {
            var file = LIBRARIES.resolve(file(component));
            var hash = HexFormat.of().formatHex(sha256.digest(Files.readAllBytes(file)));
            assertEquals(hash, hash(component), () -> file.toString());
        }
    }

    @Test
    @DisplayName("a library stands there without a licence")
    void everyLibraryHasALicence() throws IOException {
        var without = components().filter(component -> component.path("licenses").isEmpty());
        assertEquals("[]", without.map(SbomTest::file).toList().toString());
    }

    private static Stream<JsonNode> components() throws IOException {
        var bill = new ObjectMapper().readTree(BILL.toFile());
        assertEquals("CycloneDX", bill.path("bomFormat").asText());
        assertEquals("grader", bill.path("metadata").path("component").path("name").asText());
        return StreamSupport.stream(bill.path("components").spliterator(), false);
    }

    private static String file(JsonNode component) {
        return component.path("name").asText() + "-" + component.path("version").asText() + ".jar";
    }

    private static String hash(JsonNode component) {
        for (var hash : component.path("hashes")) {
            if (hash.path("alg").asText().equals("SHA-256")) return hash.path("content").asText();
        }
        return "none";
    }
}

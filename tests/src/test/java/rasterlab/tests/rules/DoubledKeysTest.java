package rasterlab.tests.rules;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.io.IOException;
import java.io.Reader;
import java.io.StringReader;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Properties;
import org.junit.jupiter.api.Test;
import rasterlab.tests.Repository;

/**
 * Keeps one text for each key: where a key stands twice in a file, the first text is never read.
 */
class DoubledKeysTest {
    @Test
    void noKeyStandsTwice() throws IOException {
        var files = bundles();
        assertFalse(files.isEmpty());
        var found = new ArrayList<String>();
        for (Path file : files) {
            try (Reader text = Files.newBufferedReader(file)) {
                for (String key : doubled(text))
                    found.add(Repository.root().relativize(file) + " " + key);
            }
        }
        assertEquals(List.of(), found, "each key needs one line");
    }

    @Test
    void aDoubledKeyIsFound() throws IOException {
        assertEquals(List.of("a b"), doubled(new StringReader("a\\ b=x\nc=y\n# c=z\na\\ b : y\n")));
    }

    private static List<String> doubled(Reader text) throws IOException {
        var keys = new KeyList();
        keys.load(text);
        return keys.doubled;
    }

    private static List<Path> bundles() throws IOException {
        var files = new ArrayList<Path>();
        for (String module : Repository.MODULES) {
            Path sources = Repository.root().resolve(module).resolve("src");
            if (!Files.exists(sources)) continue;
            try (var all = Files.walk(sources)) {
                all.filter(file -> file.toString().endsWith(".properties"))
                        .sorted()
                        .forEach(files::add);
            } catch (UncheckedIOException failure) {
                throw failure.getCause();
            }
        }
        return files;
    }

    /** Properties that note which keys come a second time. */
    private static final class KeyList extends Properties {
        private static final long serialVersionUID = 1;

        private final transient List<String> doubled = new ArrayList<>();

        @Override
        public synchronized Object put(Object key, Object value) {
            Object earlier = super.put(key, value);
            if (earlier != null) doubled.add(key.toString());
            return earlier;
        }
    }
}

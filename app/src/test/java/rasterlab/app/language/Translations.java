package rasterlab.app.language;

import java.io.IOException;
import java.io.StringReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.zip.CRC32;

/**
 * The Russian of what is said of topics: above each text stands, as a comment, the checksum of the
 * English that it was made for, so that a change of one language alone is seen.
 */
final class Translations {
    static final Path FOLDER = Path.of("../exercises/src/main/resources/rasterlab/exercises/words");
    private static final String CHECKSUM = "#[0-9a-f]{8}";

    private final Properties texts = new Properties();

    /** The checksums by the keys of the texts. */
    private final Map<String, String> checksums = new TreeMap<>();

    private Translations(List<String> lines) throws IOException {
        texts.load(new StringReader(String.join("\n", lines)));
        for (int i = 1; i < lines.size(); i++)
            if (lines.get(i - 1).matches(CHECKSUM))
                checksums.put(lines.get(i).split("=", 2)[0], lines.get(i - 1));
    }

    /** The translations of what is said of that topic. */
    static Translations of(String topic) throws IOException {
        return new Translations(Files.readAllLines(FOLDER.resolve(topic + "_ru.properties")));
    }

    /** The English of it, by the keys. */
    static Map<String, String> english(String topic) throws IOException {
        return new Translations(Files.readAllLines(FOLDER.resolve(topic + ".properties"))).texts();
    }

    Map<String, String> texts() {
        var all = new TreeMap<String, String>();
        for (String key : texts.stringPropertyNames()) all.put(key, texts.getProperty(key));
        return all;
    }

    /** A line for each key that has no translation, or whose English there is no more. */
    List<String> unmatched(Map<String, String> english) {
        var wrong = new ArrayList<String>();
        var keys = new TreeSet<>(english.keySet());
        keys.addAll(texts.stringPropertyNames());
        for (String key : keys)
            if (!texts.containsKey(key)) wrong.add(key + " has no Russian: " + english.get(key));
            else if (!english.containsKey(key)) wrong.add(key + " has no English");
        return wrong;
    }

    /** A line for each translation that was not looked at since its English was changed. */
    List<String> outdated(Map<String, String> english) {
        var wrong = new ArrayList<String>();
        english.forEach(
                (key, text) -> {
                    String sum = checksum(text);
                    if (texts.containsKey(key) && !sum.equals(checksums.get(key)))
                        wrong.add(
                                "%s: is '%s' still the Russian of '%s'? If so, write %s above it"
                                        .formatted(key, texts.getProperty(key), text, sum));
                });
        return wrong;
    }

    private static String checksum(String text) {
        var sum = new CRC32();
        sum.update(text.getBytes(StandardCharsets.UTF_8));
        return "#%08x".formatted(sum.getValue());
    }
}

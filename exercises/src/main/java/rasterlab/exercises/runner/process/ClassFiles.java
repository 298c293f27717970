package rasterlab.exercises.runner.process;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Class files of our own program, as resources: from a folder of classes or from a jar alike. */
public final class ClassFiles {
    private ClassFiles() {}

    /**
     * A class and all others below one package that its class file mentions, directly or through
     * another.
     *
     * @param prefix of the classes to follow, such as "rasterlab/contract/"
     * @return resource name, such as "rasterlab/contract/Pixels.class", to bytes
     */
    public static Map<String, byte[]> closure(Class<?> root, String prefix) {
        Pattern mention = Pattern.compile(Pattern.quote(prefix) + "[A-Za-z0-9_$/]+");
        Map<String, byte[]> found = new TreeMap<>();
        Deque<String> open = new ArrayDeque<>();
        open.add(root.getName().replace('.', '/'));
        while (!open.isEmpty()) {
            String name = open.remove() + ".class";
            if (found.containsKey(name)) continue;
            byte[] bytes = read(root, name);
            if (bytes.length == 0) continue;
            found.put(name, bytes);
            Matcher mentions = mention.matcher(new String(bytes, StandardCharsets.ISO_8859_1));
            while (mentions.find()) open.add(mentions.group());
        }
        return found;
    }

    /** The bytes, or none where the mention was no class. */
    private static byte[] read(Class<?> root, String resource) {
        try (InputStream in = root.getResourceAsStream("/" + resource)) {
            return in == null ? new byte[0] : in.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

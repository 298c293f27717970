package rasterlab.app.model;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.app.outcome.Complaint;

/**
 * Finds the files that a model names, as other people's programs spell them.
 *
 * <p>A name is tried as it is; then without quotes; then whatever its letters' case; then its last
 * part alone, beside the model and in the folders there. So a name may lead anywhere, but only
 * files in the model's own folder and below it are ever found.
 */
final class ModelFolder {
    /** Entries that are looked at for one name. */
    private static final int MOST_ENTRIES = 10_000;

    private final OwnFolder own;
    private final Path root;

    /**
     * @param file the model
     */
    ModelFolder(Path file) throws IOException {
        own = new OwnFolder(file);
        root = file.toAbsolutePath().getParent().toRealPath();
    }

    /**
     * @param name the one of the names that led to it
     */
    record FoundFile(Path file, String name) {}

    /** One way to look for a file. */
    private interface Way {
        Optional<Path> find(String name) throws IOException;
    }

    /**
     * @param names what may be meant, the likeliest first
     * @return a file; a folder or device only where it has one of the names itself
     */
    Optional<FoundFile> find(List<String> names) throws IOException {
        Map<String, String> spelled = new LinkedHashMap<>();
        for (String name : names) {
            spelled.putIfAbsent(name.replace('\\', '/'), name);
            spelled.putIfAbsent(unquoted(name).replace('\\', '/'), name);
        }
        spelled.keySet().removeIf(name -> name.isBlank() || name.indexOf('\0') >= 0);
        List<Way> ways =
                List.of(
                        name -> exact(name).filter(Files::isRegularFile),
                        name -> inAnyCase(root, List.of(name.split("/+"))),
                        name -> below(name.substring(name.lastIndexOf('/') + 1)),
                        this::exact);
        for (Way way : ways)
            for (String name : spelled.keySet()) {
                Optional<Path> found = way.find(name);
                if (found.isPresent())
                    return Optional.of(new FoundFile(found.get(), spelled.get(name)));
            }
        return Optional.empty();
    }

    private static String unquoted(String name) {
        String bare = name.strip();
        for (String quote : List.of("\"", "'"))
            if (bare.length() > 2 && bare.startsWith(quote) && bare.endsWith(quote))
                return bare.substring(1, bare.length() - 1).strip();
        return bare;
    }

    /** A name that leads out of the folder finds nothing; its last part may. */
    private Optional<Path> exact(String name) throws IOException {
        try {
            return own.find(name);
        } catch (Complaint leadsOut) {
            return Optional.empty();
        }
    }

    private Optional<Path> file(Path entry) throws IOException {
        return exact(root.relativize(entry).toString()).filter(Files::isRegularFile);
    }

    private Optional<Path> inAnyCase(Path folder, List<String> parts) throws IOException {
        if (parts.isEmpty()) return file(folder);
        String part = parts.get(0);
        List<String> rest = parts.subList(1, parts.size());
        if (part.equals(".")) return inAnyCase(folder, rest);
        if (!isOpen(folder)) return Optional.empty();
        for (Path entry : entries(folder))
            if (entry.getFileName().toString().equalsIgnoreCase(part)) {
                Optional<Path> found = inAnyCase(entry, rest);
                if (found.isPresent()) return found;
            }
        return Optional.empty();
    }

    /** The file of that name nearest below the folder, one of the same case first. */
    private Optional<Path> below(String name) throws IOException {
        var folders = new ArrayDeque<Path>(List.of(root));
        int looked = 0;
        while (!folders.isEmpty() && looked < MOST_ENTRIES) {
            Path folder = folders.remove();
            List<Path> entries = entries(folder);
            looked += entries.size();
            for (boolean sameCase : new boolean[] {true, false})
                for (Path entry : entries) {
                    String here = entry.getFileName().toString();
                    if (sameCase ? !here.equals(name) : !here.equalsIgnoreCase(name)) continue;
                    Optional<Path> found = file(entry);
                    if (found.isPresent()) return found;
                }
            for (Path entry : entries)
                if (isOpen(entry) && !Files.isSymbolicLink(entry)) folders.add(entry);
        }
        return Optional.empty();
    }

    private static boolean isOpen(Path folder) {
        return Files.isDirectory(folder) && Files.isReadable(folder);
    }

    /** Sorts by name, so that the same file is found each time. */
    private static List<Path> entries(Path folder) throws IOException {
        var entries = new ArrayList<Path>();
        try (DirectoryStream<Path> stream = Files.newDirectoryStream(folder)) {
            for (Path entry : stream) {
                if (entries.size() == MOST_ENTRIES) break;
                entries.add(entry);
            }
        }
        Collections.sort(entries);
        return entries;
    }
}

package rasterlab.exercises.runner.scan;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import rasterlab.exercises.score.Diagnostic;
import rasterlab.exercises.score.Message;

/** What is not allowed in a student's classes, each once, with the line in the source. */
final class Refusals {
    private static final int MOST = 20;

    private final List<String> sourceLines;
    private final Set<Diagnostic> found = new LinkedHashSet<>();

    Refusals(String source) {
        this.sourceLines = source.lines().toList();
    }

    /**
     * @param line from the line table; 0 where the class file has none, then the first line of the
     *     source that mentions the word is named
     * @param thing internal name of a class, with ".member" where one is meant
     */
    void add(int line, String thing) {
        if (isFull()) return;
        String readable = thing.replace('/', '.').replace('$', '.');
        int place = line > 0 ? line : mention(readable);
        found.add(new Diagnostic(place, 0, Message.of("not-allowed", readable)));
    }

    /** Whether more would not be told. */
    boolean isFull() {
        return found.size() == MOST;
    }

    private int mention(String thing) {
        String word = thing.substring(thing.lastIndexOf('.') + 1);
        Pattern pattern = Pattern.compile("\\b" + Pattern.quote(word) + "\\b");
        for (int i = 0; i < sourceLines.size(); i++)
            if (pattern.matcher(sourceLines.get(i)).find()) return i + 1;
        return 0;
    }

    List<Diagnostic> list() {
        return List.copyOf(found);
    }
}

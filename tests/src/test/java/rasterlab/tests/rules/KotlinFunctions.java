package rasterlab.tests.rules;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import rasterlab.tests.Repository;

/**
 * Measures the functions of a Kotlin source by its indentation, which the formatter keeps: a
 * function is the line with {@code fun} and what follows deeper, or closes its brackets.
 */
final class KotlinFunctions {
    private static final Pattern START =
            Pattern.compile("( *)(?:[a-z]+ )*fun (?:<.*?> )?([^(]+)\\(.*");

    private KotlinFunctions() {}

    static List<SourceFunction> of(Path file) {
        return of(file.getFileName().toString(), Repository.text(file));
    }

    static List<SourceFunction> of(String name, String source) {
        var lines = source.lines().toList();
        var found = new ArrayList<SourceFunction>();
        for (var i = 0; i < lines.size(); i++) {
            var start = START.matcher(lines.get(i));
            if (start.matches())
                found.add(
                        new SourceFunction(
                                name + "#" + start.group(2),
                                last(lines, i, start.group(1).length()) - i + 1));
        }
        return found;
    }

    private static int last(List<String> lines, int start, int indent) {
        var last = start;
        for (var i = start + 1; i < lines.size(); i++) {
            var line = lines.get(i);
            if (line.isBlank()) continue;
            var deeper = line.length() - line.stripLeading().length() - indent;
            var closes = deeper == 0 && ")}]".indexOf(line.charAt(indent)) >= 0;
            if (deeper <= 0 && !closes) break;
            last = i;
        }
        return last;
    }
}

package rasterlab.tests.build;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * The processes that run a module's tests.
 *
 * @param count how many share the tests
 * @param seconds they may take
 * @param options what Java is started with, and variables of the environment as {@code NAME=value}
 */
record Processes(String count, String seconds, Set<String> options) {
    /** The folder that holds both builds, which each of them has its own name for. */
    static final String ROOT = "<root>";

    /** A long option and its value may be two words; here they are {@code --name=value}. */
    static List<String> options(List<String> words) {
        var options = new ArrayList<String>();
        for (var left = words.iterator(); left.hasNext(); ) {
            var word = left.next();
            boolean open = word.startsWith("--") && !word.contains("=") && left.hasNext();
            options.add(open ? word + "=" + left.next() : word);
        }
        return options;
    }
}

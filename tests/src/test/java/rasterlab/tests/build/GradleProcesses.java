package rasterlab.tests.build;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;

/**
 * Reads how Gradle starts the processes of a module's tests: by blocks in which each line is one
 * call or assignment of strings and numbers. A line of any other form is an error here.
 */
final class GradleProcesses {
    private static final Pattern BLOCK =
            Pattern.compile(
                    "(?m)^( *)tasks\\.(?:test|withType<Test>\\(\\)\\.configureEach) \\{"
                            + "(?: (.*) }$|\\R((?s:.*?))^\\1}$)");
    private static final Pattern ELSEWHERE =
            Pattern.compile("<Test>|tasks\\.test|\\bjvmArg|HeapSize|\\bsystemPropert");
    private static final Pattern QUOTED = Pattern.compile("\"([^\"]*)\"");

    private static final Pattern UNSEEN =
            Pattern.compile("|//.*|useJUnitPlatform\\(\\)|" + GradleBuild.QUICK);
    private static final Pattern PROCESSES = Pattern.compile("maxParallelForks = (\\d+)");
    private static final Pattern SECONDS =
            Pattern.compile("timeout = java\\.time\\.Duration\\.ofSeconds\\((\\d+)\\)");
    private static final Pattern HEAP = Pattern.compile("maxHeapSize = \"(\\w+)\"");
    private static final Pattern PROPERTY =
            Pattern.compile("systemProperty\\(\"([\\w.]+)\", \"([^\"]*)\"\\)");
    private static final Pattern VARIABLE =
            Pattern.compile("environment\\(\"(\\w+)\", \"([^\"]*)\"\\)");
    private static final Pattern WORDS =
            Pattern.compile("jvmArgs\\((\"[^\"]*\"(?:, \"[^\"]*\")*)\\)");

    private final Map<String, String> options = new TreeMap<>();
    private String processes = "1";
    private String seconds = "";

    private GradleProcesses() {}

    /**
     * @param scripts that of all modules before the module's own, which counts where both say
     *     something
     */
    static Processes read(List<String> scripts) {
        var read = new GradleProcesses();
        for (var script : scripts) {
            BLOCK.matcher(script).results().forEach(read::addBlock);
            var rest = ELSEWHERE.matcher(BLOCK.matcher(script).replaceAll(""));
            if (rest.find())
                throw new AssertionError("'" + rest.group() + "' outside of the blocks of tests");
        }
        var options = new TreeSet<String>();
        read.options.forEach((name, value) -> options.add(name + value));
        return new Processes(read.processes, read.seconds, options);
    }

    private void addBlock(MatchResult block) {
        var lines = block.group(2) == null ? block.group(3) : block.group(2);
        lines.lines().map(String::strip).forEach(this::add);
    }

    private void add(String line) {
        var heap = HEAP.matcher(line);
        var property = PROPERTY.matcher(line);
        var variable = VARIABLE.matcher(line);
        var words = WORDS.matcher(line);
        var count = PROCESSES.matcher(line);
        var limit = SECONDS.matcher(line);
        if (count.matches()) processes = count.group(1);
        else if (limit.matches()) seconds = limit.group(1);
        else if (heap.matches()) options.put("-Xmx", heap.group(1));
        else if (property.matches()) options.put("-D" + property.group(1) + "=", property.group(2));
        else if (variable.matches()) options.put(variable.group(1) + "=", variable.group(2));
        else if (words.matches()) addWords(words.group(1));
        else if (!UNSEEN.matcher(line).matches())
            throw new AssertionError("cannot read the line of tests '" + line + "'");
    }

    private void addWords(String quoted) {
        var words =
                QUOTED.matcher(quoted)
                        .results()
                        .map(word -> word.group(1).replace("${rootDir}", Processes.ROOT))
                        .toList();
        for (var option : Processes.options(words)) options.put(option, "");
    }
}

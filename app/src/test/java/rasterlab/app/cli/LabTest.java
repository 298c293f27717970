package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.Failures;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.golden.GoldenFile;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

class LabTest {
    /** The commands that hand all words on have the help of what they call. */
    static Stream<String> commands() {
        var console = Console.of(System.in, System.out, System.err, ReportLanguage.EN);
        return Lab.commandLine(console).getSubcommands().keySet().stream()
                .filter(command -> !Set.of("grader", "bench", "help").contains(command));
    }

    @ParameterizedTest
    @MethodSource("commands")
    void everyCommandHasHelpWithAnExample(String command) {
        Ran ran = Ran.lab(command, "--help");
        assertTrue(ran.out().contains("Usage: ./lab " + command), ran.out());
        assertTrue(ran.out().contains("Example: "), ran.out());
        assertEquals(ran.out(), Ran.lab("help", command).out());
        ran.assertDone();
    }

    @Test
    void helpListsTheServerToo() {
        Ran ran = Ran.lab("help");
        assertTrue(ran.out().contains("\n  grader "), ran.out());
        assertTrue(ran.out().contains("\n  70 "), ran.out());
        ran.assertDone();
    }

    @Test
    void versionNamesTheJava() {
        Ran ran = Ran.lab("--version");
        assertTrue(ran.out().matches("(?s)Rasterlab \\d+\\.\\d+\\.\\d+\\R.*"), ran.out());
        assertTrue(ran.out().contains("Java " + System.getProperty("java.version")), ran.out());
        ran.assertDone();
    }

    @Test
    void completionKnowsTheCommands() {
        Ran ran = Ran.lab("completion");
        assertTrue(ran.out().contains("complete -F _complete_lab"), ran.out());
        assertTrue(ran.out().contains("hazards"), ran.out());
        ran.assertDone();
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void oneLineSaysWhatIsWrong(String line, String[] arguments) {
        Ran.lab(arguments).assertComplains(2, line);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "letters of a command are swapped",
                        "./lab: no command 'rneder'; there are "
                                + commandNames()
                                + "; did you mean 'render'? (see `./lab --help`)",
                        new String[] {"rneder", "vase"}),
                argumentSet(
                        "nothing is like the command",
                        "./lab: no command 'paint'; there are "
                                + commandNames()
                                + " (see `./lab --help`)",
                        new String[] {"paint"}),
                argumentSet(
                        "option is mistyped",
                        "./lab study: unknown option '--otu'; did you mean '--out'?"
                                + " (see `./lab study --help`)",
                        new String[] {"study", "line", "--otu"}),
                argumentSet(
                        "too many arguments",
                        "./lab methods: unknown argument 'circle' (see `./lab methods --help`)",
                        new String[] {"methods", "line", "circle"}),
                argumentSet(
                        "argument is missing",
                        "./lab run: needs TOPIC and METHOD, or --scene FILE; see `./lab methods`",
                        new String[] {"run", "line"}),
                argumentSet(
                        "topic is unknown",
                        "./lab methods: no topic 'cricle'; there are "
                                + topics()
                                + "; did you mean 'circle'?",
                        new String[] {"methods", "cricle"}),
                argumentSet(
                        "server is asked of the wrong program",
                        "./lab grader: the server is started by the ./lab script:"
                                + " ./lab grader serve",
                        new String[] {"grader", "serve", "--port", "0"}));
    }

    @Test
    void methodsShowsMethodsAndHazards() {
        Ran ran = Ran.lab("methods", "line");
        assertTrue(ran.out().contains("  method bresenham-textbook"), ran.out());
        assertTrue(ran.out().contains("  beyond-2-30 "), ran.out());
        ran.assertDone();
    }

    @Test
    void methodsShowsWhatEachMethodCosts() {
        String view = Ran.lab("methods", "view").out();
        assertTrue(view.contains("\n    costs:    "), view);
        assertTrue(view.replaceAll("\\s+", " ").contains("17"), view);
        assertTrue(view.lines().allMatch(line -> line.length() <= 110), view);
    }

    @Test
    void methodsSaysWhatRunReadsAndItsHelpFitsAScreen() {
        String curve = Ran.lab("methods", "curve").out();
        assertTrue(curve.contains("\n  reads:   {\"kind\":KIND, \"points\":[[x,y],...]}"), curve);
        assertTrue(curve.contains("\n  answers: {\"points\":[[x,y],...], \"segments\":n}"), curve);
        assertTrue(Ran.lab("run", "--help").out().lines().count() <= 30, "lines of help");
    }

    /** The matrices' parameters are not among them; the vocabulary lists those. */
    @ParameterizedTest(name = "{0} says nothing of a field that its example has")
    @MethodSource("topicsOfOneForm")
    void methodsNamesEveryFieldOfTheExample(String topic) {
        String said = Ran.lab("methods", topic).out();
        Pattern.compile("\"[a-z]+\":")
                .matcher(GoldenFile.example(topic))
                .results()
                .map(field -> field.group().replace(":", ""))
                .forEach(field -> assertTrue(said.contains(field), field + " in " + said));
    }

    static Stream<String> topicsOfOneForm() {
        return Topics.all().stream()
                .map(Topic::name)
                .filter(name -> !List.of("matrix", "transform").contains(name));
    }

    @Test
    void faultIsOneLineAndALog() throws Exception {
        var err = new ByteArrayOutputStream();
        var failures = new Failures(new PrintStream(err), ReportLanguage.EN);
        assertEquals(70, failures.fault("./lab run", new IllegalStateException("a\nb")));
        String line = err.toString();
        assertEquals(1, line.lines().count(), line);
        assertFalse(line.contains("\tat "), line);
        Path log = Path.of(line.substring(line.indexOf("details: ") + 9).strip());
        assertTrue(Files.readString(log).contains("\tat "), "log " + log);
        Files.delete(log);
    }

    private static String commandNames() {
        var console = Console.of(System.in, System.out, System.err, ReportLanguage.EN);
        return String.join(", ", Lab.commandLine(console).getSubcommands().keySet());
    }

    private static String topics() {
        return Topics.all().stream().map(Topic::name).collect(Collectors.joining(", "));
    }
}

package rasterlab.app.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import picocli.CommandLine;
import rasterlab.app.cli.console.Console;
import rasterlab.app.cli.console.ReportLanguage;
import rasterlab.app.language.Language;

/** Every command takes {@code --lang}, and what it prints for people is in that language. */
class RussianHelpTest {
    /** Two words one after the other, not in capitals, as the names of values are. */
    private static final Pattern ENGLISH =
            Pattern.compile("(?<![-./`\"])\\b[A-Z]?[a-z]+ [a-z]+\\b");

    static Stream<String> commands() {
        var console = Console.of(System.in, System.out, System.err, ReportLanguage.EN);
        return Lab.commandLine(console).getSubcommands().keySet().stream();
    }

    @ParameterizedTest(name = "./lab help {0} speaks English in Russian")
    @MethodSource("commands")
    void helpIsRussian(String command) {
        assertRussian(Ran.lab("help", command, "--lang", "ru"));
    }

    @Test
    @DisplayName("./lab help speaks English in Russian")
    void helpOfAllIsRussian() {
        assertRussian(Ran.lab("help", "--lang=ru"));
        assertEquals(Ran.lab("help", "--lang=ru").out(), Ran.lab("--lang", "ru", "--help").out());
    }

    @ParameterizedTest(name = "the list of commands breaks a sentence off: {0}")
    @ValueSource(strings = {"en", "ru"})
    void eachCommandIsSaidInWholeSentences(String language) {
        String said = Ran.lab("help", "--lang", language).out();
        List<String> open =
                Pattern.compile("\n  (?=[a-z])")
                        .splitAsStream(said.substring(said.indexOf("\n  methods ")))
                        .map(command -> command.split("\n\n")[0])
                        .filter(command -> command.matches("(?s)[a-z]+ .*[^.]"))
                        .toList();
        assertEquals(List.of(), open);
    }

    @ParameterizedTest(name = "a name or a bracket is broken in two by ./lab help {0}")
    @MethodSource("commands")
    void noLineEndsInTheMiddleOfAName(String command) {
        for (String language : List.of("en", "ru"))
            assertEquals(
                    List.of(),
                    Ran.lab("help", command, "--lang", language)
                            .out()
                            .lines()
                            .filter(line -> line.matches(".*(\\(\\.?|-]|--?)"))
                            .toList());
    }

    /** The commands with an exit code of their own; the others have commands or are programs. */
    static Stream<List<String>> workingCommands() {
        var console = Console.of(System.in, System.out, System.err, ReportLanguage.EN);
        return withinAll(Lab.commandLine(console), List.of())
                .filter(names -> !Set.of("bench", "grader").contains(names.get(0)))
                .filter(names -> !names.contains("help"));
    }

    private static Stream<List<String>> withinAll(CommandLine line, List<String> names) {
        if (line.getSubcommands().isEmpty()) return Stream.of(names);
        return line.getSubcommands().entrySet().stream()
                .flatMap(
                        entry -> {
                            var longer = new ArrayList<>(names);
                            longer.add(entry.getKey());
                            return withinAll(entry.getValue(), longer);
                        });
    }

    @ParameterizedTest(name = "the help of {0} lists no exit codes")
    @MethodSource("workingCommands")
    void helpListsExitCodes(List<String> names) {
        var asked = new ArrayList<>(names);
        asked.addAll(List.of("--help", "--lang"));
        Map.of("en", "Exit codes:", "ru", "Коды завершения:")
                .forEach(
                        (language, heading) -> {
                            var words = new ArrayList<>(asked);
                            words.add(language);
                            String help = Ran.lab(words.toArray(String[]::new)).out();
                            int at = help.indexOf("\n" + heading + "\n  0  ");
                            assertTrue(at >= 0, language + " help lacks exit codes:\n" + help);
                            assertTrue(help.indexOf("\n  2  ", at) > 0, "no code 2:\n" + help);
                        });
    }

    static Stream<List<String>> nestedCommands() {
        return workingCommands().filter(names -> names.size() > 1);
    }

    @ParameterizedTest(name = "help of {0} is the help of the command above it")
    @MethodSource("nestedCommands")
    void helpReachesTheCommandsBelow(List<String> names) {
        for (String language : List.of("en", "ru")) {
            String help = Ran.lab(with(names, names.size(), "--help", language)).out();
            for (int at = 0; at < names.size(); at++)
                assertEquals(help, Ran.lab(with(names, at, "help", language)).out());
        }
    }

    /** The names with a word put in at a place, and the language behind them. */
    private static String[] with(List<String> names, int at, String word, String language) {
        var words = new ArrayList<>(names);
        words.add(at, word);
        words.addAll(List.of("--lang", language));
        return words.toArray(String[]::new);
    }

    @Test
    @DisplayName("help of a command that is not there is that of the one above it")
    void helpOfNothingIsRefused() {
        Ran.lab("exercises", "help", "nww")
                .assertComplains(
                        2,
                        "./lab exercises: no command 'nww'; there are list, prove, validate, new,"
                                + " help; did you mean 'new'? (see `./lab exercises --help`)");
    }

    private static void assertRussian(Ran ran) {
        ran.assertDone();
        assertTrue(ran.out().contains("Вызов: "), ran.out());
        List<String> english =
                ran.out()
                        .lines()
                        .map(
                                line ->
                                        line.replaceAll(
                                                "`[^`]*`|\\./lab.*|'.*'|Scene files|line bresenham",
                                                ""))
                        .filter(line -> ENGLISH.matcher(line).find())
                        .toList();
        assertEquals(List.of(), english);
    }

    @Test
    @DisplayName("methods are told in English in Russian")
    void methodsAreToldInRussian() {
        String said = Ran.lab("methods", "line", "--lang", "ru").out();
        assertTrue(said.contains("  метод bresenham\n"), said);
        assertTrue(said.contains("Оба конца\u00a0— один и тот же пиксель."), said);
        assertFalse(said.contains("computes"), said);
    }

    @ParameterizedTest(name = "{0} asks for another window than {1}")
    @CsvSource({
        "--lang ru, RUSSIAN",
        "--lang=RU, RUSSIAN",
        "--lang en, ENGLISH",
        "--lang de,",
        "--lang ru methods,",
        "--lang,"
    })
    void languageAloneOpensTheWindow(String arguments, Language language) {
        assertEquals(Optional.ofNullable(language), Lab.windowIn(arguments.split(" ")));
    }
}

package rasterlab.engine.scene.obj;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class ReadingRulesTest {
    /** Tests run in the folder of their module. */
    private static final Path PAGE = Path.of("models.md");

    @Test
    @DisplayName("the page on models says other rules of models than the reader keeps")
    void pageHasTheReadersTable() throws IOException {
        String table = table();
        assertTrue(
                Files.readString(PAGE).contains(table),
                () -> "engine/" + PAGE + ": replace the table of keywords by\n" + table);
    }

    private static String table() {
        Stream<Rule> options =
                ReadingRules.OPTIONS.keySet().stream()
                        .sorted(
                                Comparator.comparing(Rule::passesOver)
                                        .thenComparing(Rule::keyword));
        String rows =
                Stream.of(
                                ReadingRules.MODEL.stream(),
                                allPassedOver(ReadingRules.MODEL_PASSED_OVER),
                                ReadingRules.MATERIALS.stream(),
                                options,
                                allPassedOver(ReadingRules.MATERIALS_PASSED_OVER))
                        .flatMap(rules -> rules)
                        .map(ReadingRulesTest::row)
                        .collect(Collectors.joining("\n"));
        return "| keyword | words | done | range | missing or unreadable |\n|---|---|---|---|---|\n"
                + rows;
    }

    private static Stream<Rule> allPassedOver(List<String> keywords) {
        return Stream.of(Rule.passedOver(String.join("`, `", keywords), ""));
    }

    private static String row(Rule rule) {
        return "| `%s` | %s | %s | %s | %s |"
                .formatted(rule.keyword(), rule.words(), done(rule), range(rule), rule.instead())
                .replaceAll(" +", " ");
    }

    private static String done(Rule rule) {
        return switch (rule.treatment()) {
            case REQUIRED, CUT, READ -> "read";
            case PASSED_OVER -> "passed over";
            case UNTOLD -> "passed over without a note";
        };
    }

    private static String range(Rule rule) {
        String range = "beyond %s to %s: ".formatted(typed(rule.least()), typed(rule.most()));
        return switch (rule.treatment()) {
            case REQUIRED -> range + "refused";
            case CUT -> range + "cut to it";
            case READ, PASSED_OVER, UNTOLD -> "";
        };
    }

    /** The number as one types it in a file. */
    private static String typed(double value) {
        return Rule.number(value).replaceFirst("\\.0E", "e");
    }
}

package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.tests.bench.BenchWords;

class RowTest {
    @ParameterizedTest(name = "whether the goal is met is not told as: {2}")
    @CsvSource({"RUSSIAN, 2.5, да", "RUSSIAN, 1.5, нет", "ENGLISH, 2.5, yes", "ENGLISH, 1.5, no"})
    void tellsInTheLanguageWhetherTheGoalIsMet(Language language, double ratio, String met) {
        var row = new Row("clear", "1.0", "Arrays.fill 2.0", ratio, 2, "");
        String line = row.line(new BenchWords(language));
        assertEquals(met, line.split(" [|] ")[5], line);
    }
}

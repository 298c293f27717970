package rasterlab.tests.bench.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.tests.bench.language.BenchWords;

class RowTest {
    @ParameterizedTest(name = "whether the goal is met is not told as: {2}")
    @CsvSource({"RUSSIAN, 2.5, да", "RUSSIAN, 1.5, нет", "ENGLISH, 2.5, yes", "ENGLISH, 1.5, no"})
    void tellsInTheLanguageWhetherTheGoalIsMet(Language language, double ratio, String met) {
        var row = new Row("clear", "1.0", "Arrays.fill 2.0", ratio, 2, words -> "");
        String line = row.line(new BenchWords(language));
        assertEquals(met, line.split(" [|] ")[5], line);
    }

    @ParameterizedTest(name = "how the pictures differ is not told as: {1}")
    @CsvSource({
        "RUSSIAN, 'пикселей, отличающихся больше чем на 2 уровня: 1 (50.0000\u00a0%); на 1 или 2: 50.00\u00a0%'",
        "ENGLISH, '1 pixels (50.0000 %) off by more than 2 levels, 50.00 % by 1 or 2'"
    })
    void tellsInTheLanguageHowThePicturesDiffer(Language language, String told) {
        var difference = Difference.of(new int[] {0, 0}, new int[] {3, 1});
        var row = new Row("clear", "1.0", "OpenGL 2.0", 2, 2, difference::text);
        String line = row.line(new BenchWords(language));
        assertEquals(told, line.split(" [|] ")[6], line);
    }
}

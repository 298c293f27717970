package rasterlab.app.canvas.widget;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.text.DecimalFormatSymbols;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TypedNumberTest {
    private static final TypedNumber ENGLISH = of(Locale.ENGLISH);
    private static final TypedNumber RUSSIAN = of(Locale.forLanguageTag("ru"));

    private static TypedNumber of(Locale locale) {
        return new TypedNumber(DecimalFormatSymbols.getInstance(locale).getGroupingSeparator());
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "a whole number is refused, 42, 42, 42",
        "a point is no decimal sign, 2.75, 2.75, 2.75",
        "a comma is no decimal sign, '2,75', 2.75, 2.75",
        "nothing before the decimal sign is refused, '−,5', -0.5, -0.5",
        "nothing behind the decimal sign is refused, 5., 5, 5",
        "a hyphen is no minus, -30.5, -30.5, -30.5",
        "a minus is no minus, '−30,5', -30.5, -30.5",
        "a plus is refused, +3, 3, 3",
        "a space behind the sign is refused, '− 3 ', -3, -3",
        "a power of ten is refused, '1,5e−7', 1.5e-7, 1.5e-7",
        "a group that cannot be one makes two readings, '0,125', 0.125, 0.125",
        "a group of four digits makes two readings, '1,2345', 1.2345, 1.2345",
        "a head of four digits makes two readings, '1234,567', 1234.567, 1234.567",
        "an English group sign is taken for a decimal sign, '1,234', 1.234 1234, 1.234",
        "a power hides two readings, '1,234e3', 1234 1234000, 1234",
        "a point makes two readings, 1.234, 1.234, 1.234",
        "groups before a point are refused, '1,234.5', 1234.5,",
        "two groups are refused, '−1,234,567', -1234567,",
        "spaces between groups are refused, '1 234 567,5', 1234567.5, 1234567.5",
        "a no-break space between groups is refused, '12\u00a0345', 12345, 12345",
        "spaces are dropped anywhere, 1 2,,",
        "a space before a fraction is dropped, 1 .5,,",
        "the end is dropped, 5x7,,",
        "a unit is dropped, 30°,,",
        "a second decimal sign is dropped, 1.5.2,,",
        "a comma after a point is dropped, '1.234,5',,",
        "two signs are taken, --5,,",
        "a power without digits is taken, 5e,,",
        "a sign is a number, −,,",
        "a decimal sign is a number, .,,",
        "nothing is a number, '',,",
        "a word is a number, NaN,,",
    })
    void readsInBothLanguages(String mistake, String text, String english, String russian) {
        assertEquals(numbers(english), ENGLISH.readings(text), mistake);
        assertEquals(numbers(russian), RUSSIAN.readings(text), mistake);
    }

    private static List<Double> numbers(String numbers) {
        if (numbers == null) return List.of();
        return Arrays.stream(numbers.split(" ")).map(Double::valueOf).toList();
    }
}

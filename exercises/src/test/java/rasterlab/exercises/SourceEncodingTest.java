package rasterlab.exercises;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.charset.Charset;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SourceEncodingTest {
    @ParameterizedTest(name = "{0} in {1} is {2}")
    @CsvSource({
        "// рисует отрезок, windows-1251, WINDOWS_1251",
        "// всё ещё «в» работе — № 5, windows-1251, WINDOWS_1251",
        "// Größe in Höhe und Länge, windows-1252, OTHER",
        "// déjà vu, windows-1252, OTHER",
        "class A {} // рисует, UTF-16LE, UTF_16",
        "class A {}, UTF-16, UTF_16",
        "class A {}, UTF-8, OTHER",
    })
    void isTold(String text, String charset, SourceEncoding expected) {
        assertEquals(expected, SourceEncoding.of(text.getBytes(Charset.forName(charset))));
    }
}

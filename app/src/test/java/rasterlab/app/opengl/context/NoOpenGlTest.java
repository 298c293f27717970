package rasterlab.app.opengl.context;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;

class NoOpenGlTest {
    @ParameterizedTest(name = "a library that is missing is told in Java''s words: {0}")
    @CsvSource({
        "Failed to locate library: libEGL.so.1",
        "Exception java.lang.UnsatisfiedLinkError: Failed to locate library: libEGL.so.1 [in thread x]"
    })
    void libraryThatIsMissingIsNamed(String message) {
        var none = new NoOpenGl(new IllegalStateException(new UnsatisfiedLinkError(message)));
        assertEquals("library libEGL.so.1 is missing", none.getMessage());
        assertEquals(
                "нет библиотеки libEGL.so.1",
                Complaints.translated(Language.RUSSIAN, none.getMessage()));
    }
}

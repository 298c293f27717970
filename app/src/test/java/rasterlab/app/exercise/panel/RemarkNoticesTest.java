package rasterlab.app.exercise.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import javax.swing.text.BadLocationException;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.SyntaxConstants;
import org.fife.ui.rsyntaxtextarea.parser.ParserNotice;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.language.Language;

class RemarkNoticesTest {
    @ParameterizedTest(name = "another place is underlined than the compiler names: {0}, {1}")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "\"    int x = 10\" | 15 | 10",
                "\"    int x = 10  // ten\" | 15 | 10",
                "\"    int x = yy;\" | 13 | yy",
                "\"    out.plt(1, 2);\" | 8 | .plt",
                "\"    out.plt(1, 2);\" | 0 | out.plt(1, 2);",
                "\"    f(1\" | 8 | 1",
                "\"    x = 1; \" | 99 | ;",
            })
    void theTokenIsUnderlined(String line, int column, String underlined) throws Exception {
        var document = document("class A {\n" + line + "\n}\n");
        ParserNotice notice = notice(document, 2, column);
        assertEquals(underlined, document.getText(notice.getOffset(), notice.getLength()));
    }

    @ParameterizedTest(name = "an empty line has nothing to underline: column {0}")
    @CsvSource({"0", "1"})
    void anEmptyLineIsMarkedAsAWhole(int column) throws Exception {
        ParserNotice notice = notice(document("class A {\n\n}"), 2, column);
        assertEquals(1, notice.getLine());
        assertEquals(-1, notice.getOffset());
    }

    private static RSyntaxDocument document(String text) throws BadLocationException {
        var document = new RSyntaxDocument(SyntaxConstants.SYNTAX_STYLE_JAVA);
        document.insertString(0, text, null);
        return document;
    }

    private static ParserNotice notice(RSyntaxDocument document, int line, int column) {
        var notices = new RemarkNotices();
        var remark = new Outcome.Remark(line, column, LocalizedText.of(language -> "wrong"));
        notices.show(List.of(remark), Language.ENGLISH);
        return notices.parse(document, SyntaxConstants.SYNTAX_STYLE_JAVA).getNotices().get(0);
    }
}

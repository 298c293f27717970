package rasterlab.app.exercise;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import javax.swing.text.BadLocationException;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.parser.AbstractParser;
import org.fife.ui.rsyntaxtextarea.parser.DefaultParseResult;
import org.fife.ui.rsyntaxtextarea.parser.DefaultParserNotice;
import org.fife.ui.rsyntaxtextarea.parser.ParseResult;
import rasterlab.app.language.Language;

/** Underlines what the last check had to say about lines of the source. */
final class RemarkNotices extends AbstractParser {
    private Language language = Language.ENGLISH;
    private List<Outcome.Remark> remarks = List.of();

    void show(List<Outcome.Remark> next, Language in) {
        remarks = byPlace(next);
        language = in;
    }

    /** What is said of one place together, one below the other: only one notice is read there. */
    static List<Outcome.Remark> byPlace(List<Outcome.Remark> remarks) {
        var places = new LinkedHashMap<List<Integer>, Outcome.Remark>();
        for (Outcome.Remark one : remarks)
            places.merge(
                    List.of(one.line(), one.column()),
                    one,
                    (first, next) ->
                            new Outcome.Remark(
                                    first.line(), first.column(), first.said().above(next.said())));
        return List.copyOf(places.values());
    }

    @Override
    public ParseResult parse(RSyntaxDocument document, String style) {
        var result = new DefaultParseResult(this);
        int lines = document.getDefaultRootElement().getElementCount();
        result.setParsedLines(0, lines - 1);
        for (Outcome.Remark remark : remarks)
            if (remark.line() >= 1 && remark.line() <= lines)
                result.addNotice(notice(remark, document));
        return result;
    }

    private DefaultParserNotice notice(Outcome.Remark remark, RSyntaxDocument document) {
        var line = document.getDefaultRootElement().getElement(remark.line() - 1);
        int end = Math.min(line.getEndOffset() - 1, document.getLength());
        int first =
                remark.column() > 0
                        ? line.getStartOffset() + remark.column() - 1
                        : firstSign(document, line.getStartOffset(), end);
        String said = remark.said().in(language);
        if (first >= end) return new DefaultParserNotice(this, said, remark.line() - 1);
        return new DefaultParserNotice(this, said, remark.line() - 1, first, end - first);
    }

    /** Where the line's indentation ends. */
    private static int firstSign(RSyntaxDocument document, int start, int end) {
        try {
            String text = document.getText(start, end - start);
            return start + text.length() - text.stripLeading().length();
        } catch (BadLocationException e) {
            throw new AssertionError("from " + start + " to " + end, e);
        }
    }

    /** The messages of each line, for the strip beside the text. */
    static List<Integer> lines(List<Outcome.Remark> remarks) {
        var lines = new ArrayList<Integer>();
        for (Outcome.Remark remark : remarks)
            if (remark.line() > 0 && !lines.contains(remark.line())) lines.add(remark.line());
        return lines;
    }
}

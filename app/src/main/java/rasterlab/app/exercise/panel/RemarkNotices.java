package rasterlab.app.exercise.panel;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import javax.swing.text.BadLocationException;
import org.fife.ui.rsyntaxtextarea.RSyntaxDocument;
import org.fife.ui.rsyntaxtextarea.Token;
import org.fife.ui.rsyntaxtextarea.parser.AbstractParser;
import org.fife.ui.rsyntaxtextarea.parser.DefaultParseResult;
import org.fife.ui.rsyntaxtextarea.parser.DefaultParserNotice;
import org.fife.ui.rsyntaxtextarea.parser.ParseResult;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.language.Language;

/** Underlines what the last check had to say about lines of the source. */
final class RemarkNotices extends AbstractParser {
    private Language language = Language.ENGLISH;
    private List<Outcome.Remark> remarks = List.of();

    void show(List<Outcome.Remark> next, Language in) {
        remarks = byPlace(next);
        language = in;
    }

    /** Joins the remarks on one place, one below the other: only one notice is read there. */
    static List<Outcome.Remark> byPlace(List<Outcome.Remark> remarks) {
        var places = new LinkedHashMap<List<Integer>, Outcome.Remark>();
        for (Outcome.Remark one : remarks)
            places.merge(
                    List.of(one.line(), one.column()),
                    one,
                    (first, next) ->
                            new Outcome.Remark(
                                    first.line(),
                                    first.column(),
                                    first.message().above(next.message())));
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
        int index = remark.line() - 1;
        String said = remark.message().in(language);
        Optional<Span> span = Span.of(document, index, remark.column());
        return span.map(at -> new DefaultParserNotice(this, said, index, at.start(), at.length()))
                .orElseGet(() -> new DefaultParserNotice(this, said, index));
    }

    /**
     * The text that is underlined.
     *
     * @param start in the document
     */
    private record Span(int start, int length) {
        /**
         * The token in that column, or the last one before it where none is there, as after a
         * missing semicolon; with what follows a dot. The whole line's where no column is known;
         * empty where the line is.
         */
        static Optional<Span> of(RSyntaxDocument document, int index, int column) {
            List<Span> tokens = tokens(document, index);
            if (tokens.isEmpty()) return Optional.empty();
            Span first = tokens.get(0);
            if (column == 0) return Optional.of(first.to(tokens.get(tokens.size() - 1)));
            int place =
                    document.getDefaultRootElement().getElement(index).getStartOffset() + column;
            int found = 0;
            for (int i = 0; i < tokens.size(); i++) if (tokens.get(i).start < place) found = i;
            Span token = tokens.get(found);
            boolean dot = token.isDot(document) && found + 1 < tokens.size();
            return Optional.of(dot ? token.to(tokens.get(found + 1)) : token);
        }

        /** The tokens of a line but for spaces and comments. */
        private static List<Span> tokens(RSyntaxDocument document, int index) {
            var tokens = new ArrayList<Span>();
            for (Token each = document.getTokenListForLine(index);
                    each != null && each.isPaintable();
                    each = each.getNextToken())
                if (!each.isCommentOrWhitespace())
                    tokens.add(new Span(each.getOffset(), each.length()));
            return tokens;
        }

        private boolean isDot(RSyntaxDocument document) {
            try {
                return document.getText(start, length).equals(".");
            } catch (BadLocationException e) {
                throw new AssertionError("from " + start + ", " + length, e);
            }
        }

        private Span to(Span last) {
            return new Span(start, last.start + last.length - start);
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

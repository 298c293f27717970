package rasterlab.exercises.formula;

import org.commonmark.parser.beta.InlineContentParser;
import org.commonmark.parser.beta.InlineParserState;
import org.commonmark.parser.beta.ParsedInline;
import org.commonmark.parser.beta.Position;
import org.commonmark.parser.beta.Scanner;

/**
 * Finds a formula within a line of text by Pandoc's rule, which leaves prices alone: no space after
 * the opening dollar, none before the closing one, and no digit after that. Since code comes before
 * formulas, a formula has no backtick.
 */
final class InlineFormulaParser implements InlineContentParser {
    @Override
    public ParsedInline tryParse(InlineParserState state) {
        Scanner scanner = state.scanner();
        int dollars = scanner.matchMultiple('$');
        boolean displayed = dollars == 2;
        if (dollars > 2 || !displayed && isSpace(scanner.peek())) return ParsedInline.none();
        Position start = scanner.position();
        while (scanner.hasNext()) {
            char next = scanner.peek();
            Position here = scanner.position();
            if (next == '`') return ParsedInline.none();
            if (next == '$') {
                boolean afterSpace = isSpace((char) scanner.peekPreviousCodePoint());
                boolean ends = scanner.matchMultiple('$') == dollars;
                boolean closes = displayed || !afterSpace && !digit(scanner.peek());
                return ends && closes
                        ? formula(scanner.getSource(start, here).getContent(), displayed, scanner)
                        : ParsedInline.none();
            }
            scanner.next();
            if (next == '\\' && scanner.hasNext()) scanner.next();
        }
        return ParsedInline.none();
    }

    private static ParsedInline formula(String tex, boolean displayed, Scanner after) {
        if (tex.isBlank()) return ParsedInline.none();
        return ParsedInline.of(
                new InlineFormula(new TexFormula(tex.strip(), displayed)), after.position());
    }

    private static boolean isSpace(char c) {
        return c == ' ' || c == '\t' || c == '\n';
    }

    private static boolean digit(char c) {
        return c >= '0' && c <= '9';
    }
}

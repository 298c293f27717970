package rasterlab.exercises.formula;

import java.util.Set;
import org.commonmark.parser.Parser;
import org.commonmark.parser.beta.InlineContentParser;
import org.commonmark.parser.beta.InlineContentParserFactory;

/**
 * Markdown with formulas: {@code $…$} within a line of text, {@code $$…$$} on lines of its own. A
 * dollar in code, one after a backslash and one beside which there is a space stay dollars.
 */
public final class FormulaMarkdown implements Parser.ParserExtension {
    @Override
    public void extend(Parser.Builder builder) {
        builder.customBlockParserFactory(new FormulaBlockParser.Factory());
        builder.customInlineContentParserFactory(
                new InlineContentParserFactory() {
                    @Override
                    public Set<Character> getTriggerCharacters() {
                        return Set.of('$');
                    }

                    @Override
                    public InlineContentParser create() {
                        return new InlineFormulaParser();
                    }
                });
    }
}

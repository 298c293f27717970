package rasterlab.exercises.formula;

import org.commonmark.node.Block;
import org.commonmark.parser.SourceLine;
import org.commonmark.parser.block.AbstractBlockParser;
import org.commonmark.parser.block.AbstractBlockParserFactory;
import org.commonmark.parser.block.BlockContinue;
import org.commonmark.parser.block.BlockStart;
import org.commonmark.parser.block.MatchedBlockParser;
import org.commonmark.parser.block.ParserState;

/**
 * Reads a block from a line that begins with two dollars to one that ends with two, so that a line
 * of the formula may begin with what would begin a list. An empty line ends it too: a forgotten end
 * costs one paragraph, not the rest of the page.
 */
final class FormulaBlockParser extends AbstractBlockParser {
    private static final String DOLLARS = "$$";

    private final FormulaBlock block = new FormulaBlock();
    private final StringBuilder tex = new StringBuilder();
    private boolean begun;
    private boolean closed;

    @Override
    public Block getBlock() {
        return block;
    }

    @Override
    public BlockContinue tryContinue(ParserState state) {
        return closed || state.isBlank()
                ? BlockContinue.none()
                : BlockContinue.atIndex(state.getIndex());
    }

    @Override
    public void addLine(SourceLine line) {
        String text = line.getContent().toString().strip();
        if (!begun) text = text.substring(DOLLARS.length());
        closed = text.endsWith(DOLLARS);
        if (closed) text = text.substring(0, text.length() - DOLLARS.length());
        if (begun) tex.append('\n');
        tex.append(text);
        begun = true;
    }

    @Override
    public void closeBlock() {
        block.set(new TexFormula(tex.toString().strip(), true), closed);
    }

    /** Starts a formula unless words follow it on its line. */
    static final class Factory extends AbstractBlockParserFactory {
        private static final int CODE_INDENT = 4;

        @Override
        public BlockStart tryStart(ParserState state, MatchedBlockParser matched) {
            String line = state.getLine().getContent().toString();
            int start = state.getNextNonSpaceIndex();
            if (state.getIndent() >= CODE_INDENT || !line.startsWith(DOLLARS, start))
                return BlockStart.none();
            String rest = line.substring(start + DOLLARS.length()).strip();
            int end = rest.indexOf(DOLLARS);
            boolean wordsFollow = end >= 0 && end + DOLLARS.length() < rest.length();
            return wordsFollow || rest.startsWith("$")
                    ? BlockStart.none()
                    : BlockStart.of(new FormulaBlockParser()).atIndex(start);
        }
    }
}

package rasterlab.exercises.formula;

import org.commonmark.node.CustomBlock;

/** A formula on lines of its own. */
public final class FormulaBlock extends CustomBlock {
    private TexFormula formula = new TexFormula("", true);
    private boolean closed;

    /** The text before the closing dollars, or before the empty line where there are none. */
    public TexFormula formula() {
        return formula;
    }

    /** Whether its end is marked. */
    public boolean closed() {
        return closed;
    }

    void set(TexFormula written, boolean isClosed) {
        formula = written;
        closed = isClosed;
    }
}

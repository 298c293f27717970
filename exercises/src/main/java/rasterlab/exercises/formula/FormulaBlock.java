package rasterlab.exercises.formula;

import org.commonmark.node.CustomBlock;

/** A formula on lines of its own. */
public final class FormulaBlock extends CustomBlock {
    private Formula formula = new Formula("", true);
    private boolean closed;

    /** What stands before the closing dollars, or before the empty line where there are none. */
    public Formula formula() {
        return formula;
    }

    /** Whether its end is marked. */
    public boolean closed() {
        return closed;
    }

    void set(Formula written, boolean isClosed) {
        formula = written;
        closed = isClosed;
    }
}

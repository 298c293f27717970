package rasterlab.exercises.formula;

import org.commonmark.node.CustomNode;

/** A formula within a line of text. */
public final class InlineFormula extends CustomNode {
    private final Formula formula;

    InlineFormula(Formula formula) {
        this.formula = formula;
    }

    public Formula formula() {
        return formula;
    }
}

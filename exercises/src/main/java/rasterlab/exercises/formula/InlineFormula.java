package rasterlab.exercises.formula;

import org.commonmark.node.CustomNode;

/** A formula within a line of text. */
public final class InlineFormula extends CustomNode {
    private final TexFormula formula;

    InlineFormula(TexFormula formula) {
        this.formula = formula;
    }

    public TexFormula formula() {
        return formula;
    }
}

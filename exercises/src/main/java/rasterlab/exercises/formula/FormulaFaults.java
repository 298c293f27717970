package rasterlab.exercises.formula;

import java.util.ArrayList;
import java.util.List;
import org.commonmark.node.AbstractVisitor;
import org.commonmark.node.CustomBlock;
import org.commonmark.node.CustomNode;
import org.commonmark.parser.Parser;
import rasterlab.exercises.score.Message;

/** Finds the formulas of a text that are no formulas, without setting any. */
public final class FormulaFaults extends AbstractVisitor {
    private final List<FaultyFormula> found = new ArrayList<>();

    private FormulaFaults() {}

    /**
     * A formula that is none.
     *
     * @param source with its dollars
     */
    public record FaultyFormula(String source, Message mistake) {}

    /** The faults of a Markdown text, in their order. */
    public static List<FaultyFormula> in(String markdown) {
        FormulaFaults faults = new FormulaFaults();
        Parser.builder()
                .extensions(List.of(new FormulaMarkdown()))
                .build()
                .parse(markdown)
                .accept(faults);
        return faults.found;
    }

    @Override
    public void visit(CustomNode node) {
        if (node instanceof InlineFormula inline) check(inline.formula());
        else visitChildren(node);
    }

    @Override
    public void visit(CustomBlock block) {
        if (!(block instanceof FormulaBlock display)) visitChildren(block);
        else if (display.closed()) check(display.formula());
        else
            found.add(
                    new FaultyFormula("$$ " + display.formula().tex(), Message.of("formula.end")));
    }

    private void check(TexFormula formula) {
        TexCheck.mistake(formula.tex())
                .ifPresent(mistake -> found.add(new FaultyFormula(formula.source(), mistake)));
    }
}

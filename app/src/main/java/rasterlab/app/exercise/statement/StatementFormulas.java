package rasterlab.app.exercise.statement;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.commonmark.node.Node;
import org.commonmark.renderer.NodeRenderer;
import org.commonmark.renderer.html.HtmlNodeRendererContext;
import org.commonmark.renderer.html.HtmlWriter;
import rasterlab.exercises.formula.FormulaBlock;
import rasterlab.exercises.formula.InlineFormula;
import rasterlab.exercises.formula.TexFormula;
import rasterlab.exercises.formula.Typeset;
import rasterlab.exercises.score.Message;

/**
 * Formulas in a statement's HTML: their source, which is shown in type where it can be set, and as
 * code with a note where it cannot.
 */
final class StatementFormulas {
    private final Function<TexFormula, Optional<Typeset>> setter;
    private final String language;
    private final Map<String, Typeset.FormulaOutline> drawn = new LinkedHashMap<>();
    private final List<TexFormula> awaited = new ArrayList<>();

    StatementFormulas(Function<TexFormula, Optional<Typeset>> setter, String language) {
        this.setter = setter;
        this.language = language;
    }

    /** Formulas by the id of the element that has the source. */
    Map<String, Typeset.FormulaOutline> drawn() {
        return Map.copyOf(drawn);
    }

    /** The settings that were not set yet. */
    List<TexFormula> awaited() {
        return List.copyOf(awaited);
    }

    NodeRenderer renderer(HtmlNodeRendererContext context) {
        return new NodeRenderer() {
            @Override
            public Set<Class<? extends Node>> getNodeTypes() {
                return Set.of(InlineFormula.class, FormulaBlock.class);
            }

            @Override
            public void render(Node node) {
                if (node instanceof FormulaBlock block) displayed(block, context.getWriter());
                else put(((InlineFormula) node).formula(), context.getWriter());
            }
        };
    }

    private void displayed(FormulaBlock block, HtmlWriter out) {
        out.line();
        out.tag("p", Map.of("class", "displayed"));
        if (block.closed()) put(block.formula(), out);
        else note("$$ " + block.formula().tex(), Message.of("formula.end"), out);
        out.tag("/p");
        out.line();
    }

    private void put(TexFormula formula, HtmlWriter out) {
        Optional<Typeset> set = setter.apply(formula);
        if (set.isEmpty()) {
            awaited.add(formula);
            out.text(formula.source());
        } else if (set.get() instanceof Typeset.FormulaOutline outline) {
            String id = "formula-" + drawn.size();
            drawn.put(id, outline);
            out.tag("span", Map.of("id", id));
            out.text(formula.source());
            out.tag("/span");
        } else note(formula.source(), ((Typeset.Mistaken) set.get()).message(), out);
    }

    private void note(String source, Message mistake, HtmlWriter out) {
        out.tag("code");
        out.text(source);
        out.tag("/code");
        out.text(" ");
        out.tag("i", Map.of("class", "mistake"));
        out.text("(" + mistake.in(language) + ")");
        out.tag("/i");
    }
}

package rasterlab.grader.web

import org.commonmark.node.AbstractVisitor
import org.commonmark.node.CustomBlock
import org.commonmark.node.CustomNode
import rasterlab.exercises.formula.FormulaBlock
import rasterlab.exercises.formula.Formulas
import rasterlab.exercises.formula.InlineFormula
import rasterlab.exercises.formula.TexFormula
import rasterlab.exercises.formula.Typeset
import rasterlab.exercises.score.Message

/**
 * A formula that a statement shows as its source, with a note.
 *
 * @param source as it stands there, with its dollars
 */
class FormulaFault(
    val source: String,
    val mistake: Message,
)

/** The formulas of a statement that cannot be set, in their order. */
fun formulaFaults(
    markdown: String,
    formulas: Formulas,
): List<FormulaFault> = buildList { statementTree(markdown).accept(FaultVisitor(formulas, this)) }

private class FaultVisitor(
    private val formulas: Formulas,
    private val found: MutableList<FormulaFault>,
) : AbstractVisitor() {
    override fun visit(node: CustomNode) = if (node is InlineFormula) check(node.formula()) else visitChildren(node)

    override fun visit(block: CustomBlock) =
        when {
            block !is FormulaBlock -> visitChildren(block)
            block.closed() -> check(block.formula())
            else -> found += unclosed(block)
        }

    private fun check(formula: TexFormula) {
        val set = formulas.set(formula)
        if (set is Typeset.Mistaken) found += FormulaFault(formula.source(), set.message())
    }
}

/** A block that its statement ends in. */
internal fun unclosed(block: FormulaBlock) = FormulaFault("$$ " + block.formula().tex(), Message.of("formula.end"))

package rasterlab.grader.web

import org.commonmark.node.AbstractVisitor
import org.commonmark.node.CustomNode
import org.commonmark.node.Node
import org.commonmark.node.Text
import org.commonmark.parser.PostProcessor
import rasterlab.exercises.formula.InlineFormula

/** A formula with what stands close to it, between which no line is broken. */
internal class UnbrokenFormula : CustomNode()

/**
 * Puts each formula into one node with the text that no space parts from it, such as a bracket or a comma: a browser
 * breaks lines on both sides of a picture, whatever sign stands there.
 */
internal object UnbrokenFormulas : PostProcessor {
    /** A whole word at most, or else signs that belong to the formula. */
    private val BEFORE = Regex("""(?<!\S)\S{1,12}$|[(\[«“]+$""")
    private val AFTER = Regex("""^\S{1,12}(?!\S)|^[,.;:!?)\]»”]+""")

    override fun process(document: Node): Node {
        val formulas = mutableListOf<InlineFormula>()
        document.accept(
            object : AbstractVisitor() {
                override fun visit(node: CustomNode) {
                    if (node is InlineFormula) formulas += node else visitChildren(node)
                }
            },
        )
        formulas.forEach(::keepTogether)
        return document
    }

    private fun keepTogether(formula: InlineFormula) {
        val before = (formula.previous as? Text)?.take(BEFORE)
        val after = (formula.next as? Text)?.take(AFTER)
        if (before == null && after == null) return
        val together = UnbrokenFormula()
        formula.insertBefore(together)
        listOfNotNull(before, formula, after).forEach(together::appendChild)
    }

    /** Takes that part out of the text; null where there is none. */
    private fun Text.take(part: Regex): Text? {
        val found = part.find(literal) ?: return null
        literal = literal.removeRange(found.range)
        return Text(found.value)
    }
}

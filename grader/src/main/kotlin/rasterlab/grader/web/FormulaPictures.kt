package rasterlab.grader.web

import org.commonmark.node.Node
import org.commonmark.renderer.NodeRenderer
import org.commonmark.renderer.html.HtmlNodeRendererContext
import org.commonmark.renderer.html.HtmlWriter
import rasterlab.exercises.formula.FormulaBlock
import rasterlab.exercises.formula.Formulas
import rasterlab.exercises.formula.InlineFormula
import rasterlab.exercises.formula.TexFormula
import rasterlab.exercises.formula.Typeset
import java.awt.geom.PathIterator
import kotlin.math.ceil
import kotlin.math.roundToInt

private const val UNITS_PER_EM = 1000

/** Pictures go below the baseline by whole steps, for each of which the style sheet has a class. */
private const val STEPS_PER_EM = 10
private const val DEEPEST = 40

/** The least share of a displayed formula's width where the page is too narrow for it. */
private const val LEAST_SHARE = 0.75

/**
 * Formulas as SVG within the page: they take its colour and size, and need no script and no style of their own.
 *
 * @param language of notes about mistakes
 */
class FormulaPictures(
    private val context: HtmlNodeRendererContext,
    private val formulas: Formulas,
    private val language: String,
) : NodeRenderer {
    private val out: HtmlWriter = context.writer

    override fun getNodeTypes(): Set<Class<out Node>> =
        setOf(InlineFormula::class.java, FormulaBlock::class.java, UnbrokenFormula::class.java)

    override fun render(node: Node) =
        when (node) {
            is FormulaBlock -> displayed(node)
            is UnbrokenFormula -> unbroken(node)
            else -> put((node as InlineFormula).formula())
        }

    private fun unbroken(node: UnbrokenFormula) {
        out.tag("span", mapOf("class" to "unbroken"))
        generateSequence(node.firstChild) { it.next }.forEach(context::render)
        out.tag("/span")
    }

    private fun displayed(block: FormulaBlock) {
        out.line()
        out.tag("p", mapOf("class" to "displayed"))
        if (block.closed()) shrinking(block.formula()) else note(unclosed(block))
        out.tag("/p")
        out.line()
    }

    /** Puts a formula that gets smaller with the page; an empty picture in its frame holds the least width. */
    private fun shrinking(formula: TexFormula) {
        val set = formulas.set(formula)
        if (set !is Typeset.FormulaOutline) return put(formula)
        out.tag("span", mapOf("class" to "shrinking"))
        picture(formula.tex(), set)
        val least = ceil(set.width() * LEAST_SHARE * UNITS_PER_EM) / UNITS_PER_EM
        out.tag("svg", mapOf("class" to "least", "aria-hidden" to "true", "width" to "${least}em", "height" to "0"))
        out.tag("/svg")
        out.tag("/span")
    }

    private fun put(formula: TexFormula) =
        when (val set = formulas.set(formula)) {
            is Typeset.FormulaOutline -> picture(formula.tex(), set)
            is Typeset.Mistaken -> note(FormulaFault(formula.source(), set.message()))
        }

    private fun picture(
        tex: String,
        drawn: Typeset.FormulaOutline,
    ) {
        val steps = ceil(drawn.depth() * STEPS_PER_EM).toInt().coerceIn(0, DEEPEST)
        val depth = maxOf(drawn.depth(), steps.toDouble() / STEPS_PER_EM)
        val (width, up, high) =
            listOf(drawn.width(), drawn.height(), drawn.height() + depth).map {
                ceil(it * UNITS_PER_EM).toInt()
            }
        val attributes =
            mapOf(
                "class" to "formula down-$steps",
                "role" to "img",
                "aria-label" to tex,
                "width" to "${width.toDouble() / UNITS_PER_EM}em",
                "height" to "${high.toDouble() / UNITS_PER_EM}em",
                "viewBox" to "0 -$up $width $high",
                "fill" to "currentColor",
            )
        out.tag("svg", attributes)
        out.tag("path", mapOf("d" to pathData(drawn)))
        out.tag("/path")
        out.tag("/svg")
    }

    private fun note(fault: FormulaFault) {
        out.tag("code")
        out.text(fault.source)
        out.tag("/code")
        out.text(" ")
        out.tag("em", mapOf("class" to "mistake"))
        out.text("(${fault.mistake.`in`(language)})")
        out.tag("/em")
    }
}

/** The outline in whole thousandths of an em. */
private fun pathData(drawn: Typeset.FormulaOutline): String =
    buildString {
        val at = drawn.outline().getPathIterator(null)
        val c = DoubleArray(6)
        while (!at.isDone) {
            val (letter, numbers) = segment(at.currentSegment(c))
            append(letter)
            for (i in 0 until numbers) {
                if (i > 0) append(' ')
                append((c[i] * UNITS_PER_EM).roundToInt())
            }
            at.next()
        }
    }

private fun segment(kind: Int): Pair<Char, Int> =
    when (kind) {
        PathIterator.SEG_MOVETO -> 'M' to 2
        PathIterator.SEG_LINETO -> 'L' to 2
        PathIterator.SEG_QUADTO -> 'Q' to 4
        PathIterator.SEG_CUBICTO -> 'C' to 6
        else -> 'Z' to 0
    }

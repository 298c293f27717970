// Programs that are alike, as evidence for a person: tokens, their fingerprints, pairs, pages. Start with Similar.
package rasterlab.grader.similarity

import com.sun.source.tree.BlockTree
import com.sun.source.tree.CompilationUnitTree
import com.sun.source.tree.ErroneousTree
import com.sun.source.tree.ImportTree
import com.sun.source.tree.ModifiersTree
import com.sun.source.tree.ParenthesizedTree
import com.sun.source.tree.Tree
import com.sun.source.util.JavacTask
import com.sun.source.util.TreeScanner
import com.sun.source.util.Trees
import java.io.IOException
import java.net.URI
import javax.tools.DiagnosticCollector
import javax.tools.JavaFileObject
import javax.tools.SimpleJavaFileObject
import javax.tools.ToolProvider

/**
 * A token says what a program does at one place, whatever things are called there.
 *
 * @param kind of the node in the compiler's syntax tree
 * @param line where it begins, from 1
 */
data class SourceToken(
    val kind: String,
    val line: Int,
)

/** Reads the tokens of a Java source by the compiler's parser; names, layout, comments and brackets leave no trace. */
object SourceTokens {
    /**
     * The nodes of the syntax tree, each before what it holds.
     *
     * @return empty where the source is no Java, or is nested too deep to be parsed
     */
    fun of(source: String): List<SourceToken> {
        val compiler = checkNotNull(ToolProvider.getSystemJavaCompiler()) { "no compiler: the server needs a JDK" }
        val faults = DiagnosticCollector<JavaFileObject>()
        val task =
            compiler.getTask(null, null, faults, listOf("-proc:none"), null, listOf(Text(source))) as JavacTask
        return try {
            val unit = task.parse().single()
            if (faults.diagnostics.isEmpty()) Reader(task, unit).read() else emptyList()
        } catch (failed: IllegalStateException) {
            // how the compiler tells that its stack was too small
            if (failed.cause !is StackOverflowError) throw failed
            emptyList()
        } catch (failed: IOException) {
            throw IllegalStateException("a source in memory cannot be read", failed)
        }
    }

    private class Text(
        private val source: String,
    ) : SimpleJavaFileObject(URI.create("string:///Source.java"), JavaFileObject.Kind.SOURCE) {
        override fun getCharContent(ignoreEncodingErrors: Boolean) = source
    }

    private class Reader(
        task: JavacTask,
        private val unit: CompilationUnitTree,
    ) : TreeScanner<Unit, Unit>() {
        private val positions = Trees.instance(task).sourcePositions
        private val tokens = mutableListOf<SourceToken>()

        fun read(): List<SourceToken> {
            scan(unit, Unit)
            return tokens
        }

        override fun scan(
            tree: Tree?,
            nothing: Unit,
        ) {
            if (tree == null || tree is ImportTree || tree is ModifiersTree || tree is ErroneousTree) return
            val isTold = tree !is CompilationUnitTree && tree !is ParenthesizedTree
            if (isTold) add(tree.kind.name, positions.getStartPosition(unit, tree))
            super.scan(tree, nothing)
            if (tree is BlockTree) add("END", positions.getEndPosition(unit, tree) - 1)
        }

        /** A node that the compiler has added itself, such as a constructor, stands at no place. */
        private fun add(
            kind: String,
            position: Long,
        ) {
            if (position >= 0) tokens += SourceToken(kind, unit.lineMap.getLineNumber(position).toInt())
        }
    }
}

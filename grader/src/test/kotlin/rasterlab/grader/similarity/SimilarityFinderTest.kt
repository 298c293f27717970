package rasterlab.grader.similarity

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import kotlin.random.Random

/** Programs whose parts are alike are found, whatever else was changed in them. */
class SimilarityFinderTest {
    private fun program(
        student: String,
        body: String,
    ) = Program("of-$student", student, "class Own {\n$body\n}\n")

    private fun pairs(vararg programs: Program) = SimilarityFinder(programs.toList(), STARTER).pairs(10)

    @Test
    @DisplayName("new names, comments, brackets and another layout hide that a program was copied")
    fun namesAndLayoutDoNotMatter() {
        val changed =
            MIDPOINT
                .replace("error", "e")
                .replace("steps", "theCount")
                .replace("dx", "a")
                .replace("; ", ";\n        // a comment\n        ")
                .replace("2 * a", "(2 * a)")
        val pair = pairs(program("ada", MIDPOINT), program("eve", changed)).single()
        assertEquals(1.0, pair.shared)
        assertTrue(pair.rare > 3, "$pair")
    }

    @Test
    @DisplayName("a copied method is not found in a program that is otherwise its author's own")
    fun copiedMethodIsFound() {
        val own = "int sum(int[] all) { int s = 0; for (int one : all) s += one; return s; }\n"
        val pair = pairs(program("ada", MIDPOINT), program("eve", own + SLOPE + MIDPOINT)).single()
        assertTrue(pair.shared > 0.9, "$pair")
        val copied = SimilarityFinder(listOf(pair.first, pair.second), STARTER).lines(pair.second, pair.first)
        assertTrue(4 in copied && 2 !in copied, "$copied")
    }

    @Test
    @DisplayName("two ways to draw a line pass for one")
    fun differentMethodsAreNotAlike() {
        assertEquals(emptyList<AlikePair>(), pairs(program("ada", MIDPOINT), program("eve", SLOPE)))
    }

    @Test
    @DisplayName("what the starter gives to all makes programs alike")
    fun starterIsTakenOut() {
        val programs = listOf("ada", "eve").map { Program(it, it, STARTER.replace("given", it)) }
        val alike = SimilarityFinder(programs, STARTER)
        assertEquals(emptyList<AlikePair>(), alike.pairs(10))
        assertEquals(programs, alike.leftOut)
    }

    @Test
    @DisplayName("what a whole class writes alike counts as rare, or hides the two that share more")
    fun commonRunsAreNotRare() {
        val usual = ('a'..'h').map { program("$it", MIDPOINT) }
        val two = listOf("ada", "eve").map { program(it, MIDPOINT + SLOPE) }
        val pairs = SimilarityFinder(usual + two, STARTER).pairs(100)
        assertEquals(listOf("ada", "eve"), listOf(pairs[0].first.student, pairs[0].second.student))
        assertTrue(pairs[0].rare > 0)
        assertTrue(pairs.drop(1).all { it.rare == 0 }, "$pairs")
    }

    @Test
    @DisplayName("a student's own two programs are called alike")
    fun ownProgramsAreNotCompared() {
        assertEquals(emptyList<AlikePair>(), pairs(program("ada", MIDPOINT), program("ada", MIDPOINT)))
    }

    @Test
    @DisplayName("a source that is no Java, or nested too deep for the parser, stops the comparing")
    fun badSourcesAreLeftOut() {
        val deep = "int x() { return ${"(1 + ".repeat(20_000)}1${")".repeat(20_000)}; }"
        val bad = listOf(program("ada", "int x( {"), program("eve", deep), Program("empty", "empty", ""))
        assertEquals(bad, SimilarityFinder(bad, STARTER).leftOut)
    }

    @Test
    @DisplayName("a window of hashes has none that is kept, so that a shared run could be missed")
    fun eachWindowKeepsAHash() {
        val seed = System.nanoTime()
        println("seed $seed")
        val random = Random(seed)
        repeat(200) {
            val hashes = List(random.nextInt(1, 100)) { random.nextLong(5) }
            val kept = Fingerprints.winnow(hashes).toSet()
            for (first in 0..hashes.size - Fingerprints.WINDOW) {
                assertTrue((first until first + Fingerprints.WINDOW).any { it in kept }, "$hashes at $first: $kept")
            }
            assertTrue(kept.isNotEmpty())
        }
    }

    private companion object {
        const val STARTER =
            "class Own { int given(int x) { int sum = 0; for (int i = 0; i < x; i++) sum += i * i; return sum; } }"

        const val MIDPOINT =
            "void draw(int x, int y, int dx, int dy) { int steps = dx; int error = 2 * dy - dx; " +
                "for (int i = 0; i <= steps; i++) { put(x, y); if (error > 0) { y++; error -= 2 * dx; } " +
                "error += 2 * dy; x++; } } void put(int x, int y) { pixels[y * width + x] = 1; }\n"

        const val SLOPE =
            "double[] line(double a, double b, double c, double d) { double k = (d - b) / (c - a); " +
                "double[] ys = new double[(int) (c - a) + 1]; int n = 0; " +
                "while (n < ys.length) { ys[n] = Math.round(b + k * n); n = n + 1; } return ys; }\n"
    }
}

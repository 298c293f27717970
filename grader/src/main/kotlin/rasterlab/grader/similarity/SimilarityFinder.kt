package rasterlab.grader.similarity

/**
 * A program that is compared with the others.
 *
 * @param id of its submission
 * @param student who handed it in; a student's own programs are not compared with each other
 */
class Program(
    val id: String,
    val student: String,
    val source: String,
) {
    val tokens: List<SourceToken> = SourceTokens.of(source)
}

/**
 * Two programs that have something in common.
 *
 * @param shared how much of the smaller program's fingerprints the other one has, 0 to 1
 * @param rare fingerprints of both that hardly anybody else has
 * @param longest tokens in a row that are alike in both
 */
data class AlikePair(
    val first: Program,
    val second: Program,
    val shared: Double,
    val rare: Int,
    val longest: Int,
)

/**
 * Compares programs for one exercise, without what its starter gives to all.
 *
 * Where many programs have a run of tokens, it is the exercise's own way to be written and says nothing about two of them;
 * so pairs are ordered by what few have.
 */
class SimilarityFinder(
    private val programs: List<Program>,
    starter: String,
) {
    private val given = Fingerprints.runs(SourceTokens.of(starter)).toSet()
    private val prints = programs.associateWith { Fingerprints.of(it.tokens, given) }
    private val owners: Map<Long, List<Program>> =
        prints.entries
            .flatMap { (program, prints) -> prints.hashes.map { it to program } }
            .groupBy({ it.first }, { it.second })
    private val few = maxOf(FEW, programs.distinctBy { it.student }.size / SHARE_OF_FEW)

    /** The programs that are no Java, or too short to have a fingerprint. */
    val leftOut: List<Program> = programs.filter { prints.getValue(it).hashes.isEmpty() }

    /**
     * The pairs of two students' programs that have most in common.
     *
     * @param most how many
     */
    fun pairs(most: Int): List<AlikePair> {
        val common = mutableMapOf<Pair<Program, Program>, MutableList<Long>>()
        for ((hash, all) in owners) {
            for (i in all.indices) {
                for (j in i + 1 until all.size) {
                    if (all[i].student == all[j].student) continue
                    common.getOrPut(all[i] to all[j]) { mutableListOf() } += hash
                }
            }
        }
        return common
            .map { (pair, hashes) -> weighed(pair.first, pair.second, hashes) }
            .filter { it.rare > 0 || it.shared >= MUCH }
            .sortedWith(
                compareByDescending<AlikePair> { it.rare }.thenByDescending { it.shared }.thenBy { it.first.id },
            ).take(most)
            .map { it.copy(longest = longest(it.first, it.second)) }
    }

    private fun weighed(
        first: Program,
        second: Program,
        common: List<Long>,
    ): AlikePair {
        val smaller = minOf(prints.getValue(first).hashes.size, prints.getValue(second).hashes.size)
        val rare = common.count { hash -> owners.getValue(hash).distinctBy { it.student }.size <= few }
        return AlikePair(first, second, common.size.toDouble() / smaller, rare, longest = 0)
    }

    /** The lines of the first program, from 1, that hold what the second one has too. */
    fun lines(
        first: Program,
        second: Program,
    ): Set<Int> = runs(first, second).flatten().mapTo(sortedSetOf()) { first.tokens[it].line }

    private fun longest(
        first: Program,
        second: Program,
    ) = runs(first, second).maxOfOrNull { it.last - it.first + 1 } ?: 0

    /** Indices of the tokens that are alike, joined where they touch. */
    private fun runs(
        first: Program,
        second: Program,
    ): List<IntRange> {
        val other = Fingerprints.runs(second.tokens).toSet() - given
        val alike = sortedSetOf<Int>()
        Fingerprints.runs(first.tokens).forEachIndexed { start, hash ->
            if (hash in other) alike += start until start + Fingerprints.RUN
        }
        return alike.fold(mutableListOf()) { runs, index ->
            val last = runs.lastOrNull()
            if (last != null && last.last + 1 == index) {
                runs[runs.size - 1] = last.first..index
            } else {
                runs += index..index
            }
            runs
        }
    }

    private companion object {
        /** Students, oneself among them, that have a run of tokens which is still called rare. */
        const val FEW = 3

        /** One in so many students of a large class are few, too. */
        const val SHARE_OF_FEW = 20

        /** Programs that share so much are shown although each part of them is common. */
        const val MUCH = 0.8
    }
}

package rasterlab.grader.similarity

/**
 * Some of the hashes of all runs of [RUN] tokens in a program, chosen by winnowing: of each [WINDOW] hashes in a row the
 * least one, of equal ones the last. Whatever two programs share in at least [RUN] + [WINDOW] − 1 tokens in a row is found.
 *
 * Source: Schleimer, Wilkerson, Aiken: Winnowing: local algorithms for document fingerprinting, SIGMOD 2003, 76–85.
 *
 * @param places hash to the index of the first token of each run that has it
 */
class Fingerprints private constructor(
    val places: Map<Long, List<Int>>,
) {
    val hashes: Set<Long> get() = places.keys

    companion object {
        /** Tokens whose order is looked at together; fewer are alike in programs of strangers. */
        const val RUN = 12

        /** Hashes of which one is kept. */
        const val WINDOW = 8

        private const val FACTOR = 1_000_003L

        /**
         * The fingerprints of a program.
         *
         * @param apart hashes that everybody has, those of the starter
         */
        fun of(
            tokens: List<SourceToken>,
            apart: Set<Long> = emptySet(),
        ): Fingerprints {
            val hashes = runs(tokens)
            val chosen = winnow(hashes).filter { hashes[it] !in apart }
            return Fingerprints(chosen.groupBy { hashes[it] })
        }

        /** The hash of each run of [RUN] tokens, in the order of the runs. */
        fun runs(tokens: List<SourceToken>): List<Long> =
            tokens.windowed(RUN) { run -> run.fold(0L) { sum, token -> sum * FACTOR + token.kind.hashCode() } }

        /** Indices of the hashes that are kept, in rising order. */
        internal fun winnow(hashes: List<Long>): List<Int> {
            if (hashes.size <= WINDOW) return listOfNotNull(hashes.indices.minWithOrNull(lastOfTheLeast(hashes)))
            return (0..hashes.size - WINDOW)
                .map { first -> (first until first + WINDOW).minWith(lastOfTheLeast(hashes)) }
                .distinct()
        }

        private fun lastOfTheLeast(hashes: List<Long>) = compareBy<Int> { hashes[it] }.thenByDescending { it }
    }
}

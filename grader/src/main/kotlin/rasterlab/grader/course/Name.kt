package rasterlab.grader.course

import rasterlab.grader.problem.Rejection
import java.text.Normalizer

/** The name of a course or a student: NFC, 1 to 80 code points, no control or formatting characters. */
class Name private constructor(
    val text: String,
) {
    companion object {
        private const val LONGEST = 80

        /** @param what the field that holds it, for the message */
        fun of(
            raw: String,
            what: String = "name",
        ): Name {
            // The text is cut before normalising, which takes time; NFC at most triples a text.
            if (raw.length > LONGEST * 8) throw Rejection.BadName(what, LONGEST)
            val text = Normalizer.normalize(raw.trim(), Normalizer.Form.NFC)
            val points = text.codePoints().toArray()
            if (points.size !in 1..LONGEST || points.any { !allowed(it) }) throw Rejection.BadName(what, LONGEST)
            return Name(text)
        }

        private fun allowed(point: Int) =
            when (Character.getType(point).toByte()) {
                Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.PRIVATE_USE, Character.UNASSIGNED,
                Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR,
                -> false

                else -> true
            }
    }
}

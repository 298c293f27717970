package rasterlab.grader.course

import rasterlab.grader.problem.Rejection
import java.text.Normalizer

/**
 * The name of a course or a student: NFC, 1 to 80 code points, one space where there are several, no control or
 * formatting characters, and none that shows nothing.
 */
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
            val text = Normalizer.normalize(spaced(raw.trim()), Normalizer.Form.NFC)
            val points = text.codePoints().toArray()
            if (points.size !in 1..LONGEST || points.any { !allowed(it) }) throw Rejection.BadName(what, LONGEST)
            return Name(text)
        }

        /** The text with one space for each run of them, as a page shows it. */
        fun spaced(text: String): String = SPACES.replace(text, " ")

        private val SPACES = Regex("\\p{Zs}+")

        /**
         * Letters and marks that show nothing: the braille blank, and those of Unicode's Default_Ignorable_Code_Point
         * (DerivedCoreProperties.txt) that no category below has.
         */
        private val BLANK =
            listOf(
                0x034F..0x034F,
                0x115F..0x1160,
                0x17B4..0x17B5,
                0x180B..0x180F,
                0x2800..0x2800,
                0x3164..0x3164,
                0xFE00..0xFE0F,
                0xFFA0..0xFFA0,
                0xE0100..0xE01EF,
            )

        private fun allowed(point: Int) = BLANK.none { point in it } && isShown(point)

        private fun isShown(point: Int) =
            when (Character.getType(point).toByte()) {
                Character.CONTROL, Character.FORMAT, Character.SURROGATE, Character.PRIVATE_USE, Character.UNASSIGNED,
                Character.LINE_SEPARATOR, Character.PARAGRAPH_SEPARATOR,
                -> false

                else -> true
            }
    }
}

package rasterlab.grader.course

/**
 * Tells under which name each student of a course is shown: no two under one, and a name that ends like one with a number
 * is not mistaken for one.
 *
 * @param before the names that are shown, by the student's number
 */
internal class ShownNames(
    before: Map<Int, String>,
) {
    private val shown = HashMap(before)
    private val taken = before.values.toHashSet()

    /** The name that the student of that [number] is shown under from now on. */
    fun give(
        number: Int,
        name: Name,
    ): String {
        shown.remove(number)?.let(taken::remove)
        val numbered = name.text in taken || name.text.endsWith(")")
        val given = if (numbered) "${name.text} ($number)" else name.text
        shown[number] = given
        taken += given
        return given
    }
}

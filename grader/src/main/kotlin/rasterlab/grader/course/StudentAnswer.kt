package rasterlab.grader.course

import kotlinx.serialization.Serializable
import rasterlab.grader.storage.text

/** A student as staff are told; the number of the institution and the address are for those who may take data away. */
@Serializable
internal data class StudentAnswer(
    val student: String,
    val number: Int,
    val name: String,
    val shownName: String,
    val idNumber: String?,
    val email: String?,
    val joinedAt: String,
)

/** @param withRoster whether the reader may know what rosters said */
internal fun Enrolled.told(withRoster: Boolean): StudentAnswer {
    val known = if (withRoster) fields else emptyMap()
    return StudentAnswer(id, number, name, shownName, known.idNumber, known.email, joinedAt.text())
}

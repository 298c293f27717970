package rasterlab.grader.similarity

import rasterlab.exercises.Exercise
import java.io.OutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

/**
 * All programs for an exercise in one ZIP file that other tools read: JPlag a folder for each submission and the starter
 * as base code, Dolos the table `info.csv` with the columns `filename`, `label`, `full_name` and `created_at`.
 */
internal object ProgramsFile {
    private const val STARTER = "starter/Starter.java"

    fun write(
        programs: List<HandedProgram>,
        exercise: Exercise,
        out: OutputStream,
    ) = ZipOutputStream(out).use { zip ->
        zip.add("info.csv", table(programs))
        zip.add(STARTER, exercise.starter())
        programs.forEach { zip.add(path(it), it.source) }
    }

    private fun table(programs: List<HandedProgram>): String =
        (listOf("filename,label,full_name,created_at") + programs.map(::line)).joinToString("\n", postfix = "\n")

    private fun line(one: HandedProgram) =
        listOf(path(one), one.course, one.name, "${one.receivedAt}").joinToString(",", transform = ::quoted)

    private fun quoted(text: String) = "\"${text.replace("\"", "\"\"")}\""

    /** The path has the submission's id, since names of students are no names of files. */
    private fun path(one: HandedProgram) = "submissions/${one.submission}/Program.java"

    private fun ZipOutputStream.add(
        name: String,
        text: String,
    ) {
        putNextEntry(ZipEntry(name))
        write(text.toByteArray())
        closeEntry()
    }
}

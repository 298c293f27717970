package rasterlab.grader.exercise

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.DisplayName
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.catalogue.Catalogue
import rasterlab.grader.postgres.TestDatabases
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

open class KeptExercisesTest {
    @TempDir
    lateinit var folder: Path
    private val id = "line-bresenham"

    @Test
    @DisplayName("an exercise that was changed is gone, or half of it")
    fun anExerciseIsKeptAsItWas() {
        val own = folder.resolve("own/$id")
        val builtIn = Catalogue.builtIn()
        builtIn.files(id).forEach { (name, content) ->
            own.resolve(name).also { it.parent.createDirectories() }.writeBytes(content)
        }
        val before = catalogue()
        val changed = own.resolve("exercise.json")
        changed.writeText(changed.readText().replaceFirst("\"en\": \"", "\"en\": \"Once more: "))
        val after = catalogue()
        TestDatabases.open(folder).use { database ->
            KeptExercises(database).run {
                keep(before)
                keep(after)
                keep(after)
            }
            val kept = KeptExercises(database)
            for (one in listOf(before, after).map { it.named(id) }) {
                val found = checkNotNull(kept.find(id, one.revision())) { "${one.revision()} is not kept" }
                assertEquals(one.revision(), found.revision())
                assertEquals(one.title(), found.title())
                assertEquals(one.cases(), found.cases())
                assertEquals(one.statement(), found.statement())
                assertEquals(one.pictures().keys, found.pictures().keys)
            }
            assertEquals(null, kept.find(id, "0000000000000000"))
        }
    }

    private fun catalogue() = Catalogue.builtIn().withFolder(folder.resolve("own"))
}

package rasterlab.grader

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import rasterlab.exercises.catalogue.Catalogue
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.readText
import kotlin.io.path.writeText

class OwnExercisesTest {
    @TempDir
    lateinit var folder: Path

    private fun told(language: String): List<String> {
        val all = Catalogue.builtIn().withFolder(folder)
        val own = all.all().filter { it.id() == ID }
        return OwnExercises(folder, own, all.replaced()).told(CommandWords.asked("--lang", language))
    }

    private fun exercise(
        statement: String,
        id: String = ID,
    ) {
        val sub = folder.resolve(id).createDirectory()
        for (file in FILES) {
            val source = Catalogue::class.java.getResourceAsStream("/rasterlab/exercises/line-bresenham/$file")!!
            source.use { Files.copy(it, sub.resolve(file)) }
        }
        sub.resolve("statement.ru.md").writeText(statement)
    }

    @Test
    fun `an empty folder is taken in silence`() {
        assertEquals(
            listOf("--exercises $folder: no exercise is there; expected a sub-folder with an exercise.json for each"),
            told("en"),
        )
    }

    @Test
    fun `what was found is not said, or sound formulas are complained of`() {
        exercise("\$x_0\$\n\n\$\$\ny\n\$\$\n")
        assertEquals(listOf("--exercises $folder: найдено заданий: 1 ($ID)"), told("ru"))
    }

    @Test
    fun `a built-in exercise is replaced without a word`() {
        exercise("sound", "line-bresenham")
        assertEquals("line-bresenham of $folder takes the place of the built-in exercise", told("en")[1])
    }

    @Test
    fun `only a student finds a broken formula`() {
        exercise("in a table\n\n|a|\n|-|\n|\$\\nope\$|\n\n\$\$\nx\n")
        val broken = told("en").drop(1)
        assertEquals(2, broken.size, "$broken")
        val file = folder.resolve("$ID/statement.ru.md")
        assertEquals("$file: formula \$\\nope\$: \\nope is not a command that is known here", broken[0])
        assertTrue(broken[1].endsWith("the closing \$\$ is missing"), broken[1])
    }

    @Test
    fun `only a student finds a broken formula of a hint`() {
        exercise("sound")
        val file = folder.resolve("$ID/hints.en.md")
        file.writeText(file.readText().replace("## 2\n", "## 2\n\n\$\\nope\$"))
        assertEquals(
            listOf("$file: formula \$\\nope\$: \\nope is not a command that is known here"),
            told("en").drop(1),
        )
    }

    private companion object {
        const val ID = "my-line"
        val FILES =
            listOf(
                "exercise.json",
                "cases.json",
                "hidden-cases.json",
                "segment.svg",
                "Starter.java",
                "statement.en.md",
                "hints.en.md",
                "hints.ru.md",
            )
    }
}

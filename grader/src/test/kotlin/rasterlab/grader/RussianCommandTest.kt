package rasterlab.grader

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import java.io.PrintWriter
import java.io.StringWriter
import java.nio.file.Path
import java.util.Properties
import kotlin.io.path.createFile

/** What the server prints with `--lang ru`. */
class RussianCommandTest {
    @TempDir
    lateinit var folder: Path

    private val printed = StringWriter()

    private fun run(vararg arguments: String): Int =
        commandLine(CommandWords.asked(*arguments))
            .setOut(PrintWriter(printed, true))
            .setErr(PrintWriter(printed, true))
            .execute(*arguments)

    private fun assertRussian(said: String = printed.toString()) {
        assertTrue(Regex("[а-яё]{3}").containsMatchIn(said), said)
        val told = said.replace(folder.toString(), "").replace(Regex("\\./lab grader[a-z ]*|--[a-z]+ \\S+"), "")
        assertEquals(null, Regex("\\b[A-Z]?[a-z]{2,} [a-z]{2,}\\b").find(told)?.value, said)
    }

    @ParameterizedTest(name = "./lab grader {0} speaks English in Russian")
    @ValueSource(strings = ["--help", "serve --help", "help serve", "help help"])
    fun `help is Russian`(call: String) {
        assertEquals(0, run(*"$call --lang ru".split(" ").toTypedArray()))
        assertTrue(printed.toString().contains("Вызов: ./lab grader"), printed.toString())
        assertRussian()
    }

    @ParameterizedTest(name = "./lab grader {0} is answered in English")
    @ValueSource(
        strings = [
            "--lang ru",
            "serve --lang=ru --port x",
            "serve --port --lang ru",
            "serve --port -1 --lang RU",
            "serve --workers 0 --lang ru",
            "serve --host no.such.host.invalid --lang ru",
            "serve --exam --exam --lang ru",
            "serve --more --lang ru",
            "serve more --lang ru",
            "serve --port 0 --db h2:x --lang ru",
            "serve --port 0 --db sqlite:?x --lang ru",
            "serve --port 0 --db sqlite:FOLDER --lang ru",
            "serve --port 0 --db sqlite:FOLDER/none/a --lang ru",
            "serve --port 0 --data FILE --lang ru",
        ],
    )
    fun `complaints are Russian`(call: String) {
        val file = folder.resolve("a").createFile()
        val words = call.replace("FOLDER", "$folder").replace("FILE", "$file").split(" ")
        assertEquals(2, run(*words.toTypedArray()), printed.toString())
        assertRussian()
        assertEquals(
            1,
            printed
                .toString()
                .trim()
                .lines()
                .size,
        )
    }

    @ParameterizedTest(name = "a text of {0} is missing in one language")
    @ValueSource(strings = ["command", "storage/reasons"])
    fun `each text is there in both languages`(name: String) {
        val english = keys("$name.properties")
        val help = Regex("(\\./lab grader|usage)\\..*|help|version|lang.*|data|host|port|db|exam|exercises|workers.*")
        val russian = keys("${name}_ru.properties").filterNot { name == "command" && help.matches(it) }
        assertEquals(english, russian.toSet())
    }

    private fun keys(file: String): Set<String> {
        val texts = Properties()
        CommandWords::class.java
            .getResourceAsStream(file)!!
            .reader()
            .use(texts::load)
        return texts.stringPropertyNames()
    }
}

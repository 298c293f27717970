package rasterlab.grader

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource
import rasterlab.exercises.score.Message
import rasterlab.grader.storage.CannotStart
import rasterlab.grader.storage.CannotStart.StartFailure
import rasterlab.grader.storage.DataFolder
import rasterlab.grader.storage.SqliteFile
import java.io.PrintWriter
import java.io.StringWriter
import java.net.InetAddress
import java.net.ServerSocket
import java.nio.file.Path
import java.util.Locale
import java.util.Properties
import kotlin.io.path.createDirectories
import kotlin.io.path.createFile
import kotlin.io.path.createLinkPointingTo
import kotlin.io.path.writeText

/** Reads what the server prints with `--lang ru`. */
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
        val named = Regex("\\./lab grader[a-z ]*|--[a-z]+ \\S+|\\([A-Za-z]+Exception: .*\\)")
        val told = said.replace(folder.toString(), "").replace(named, "")
        assertEquals(null, Regex("\\b[A-Z]?[a-z]{2,} [a-z]{2,}\\b").find(told)?.value, said)
    }

    @ParameterizedTest(name = "./lab grader {0} speaks English in Russian")
    @ValueSource(
        strings = [
            "--help",
            "serve --help",
            "help serve",
            "worker --help",
            "help help",
            "backup --help",
            "restore --help",
            "token --help",
            "course --help",
            "course list --help",
            "course create --help",
            "course exercises --help",
            "course roster --help",
            "course rules --help",
            "course extend --help",
            "course grades --help",
            "student --help",
            "student list --help",
            "student show --help",
            "student export --help",
            "student delete --help",
            "help student delete",
            "export --help",
            "staff --help",
            "staff list --help",
            "staff add --help",
            "staff token --help",
            "staff rename --help",
            "staff revoke --help",
            "lti --help",
            "lti list --help",
            "lti add --help",
            "lti remove --help",
            "regrade --help",
            "regrade start --help",
            "regrade list --help",
            "regrade show --help",
            "regrade accept --help",
            "regrade discard --help",
            "regrade undo --help",
        ],
    )
    fun `help is Russian`(call: String) {
        assertEquals(0, run(*"$call --lang ru".split(" ").toTypedArray()))
        assertTrue(printed.toString().contains("Вызов: ./lab grader"), printed.toString())
        assertTrue(
            Regex("Коды завершения:\\R +0 +сделано\\R +2 +.*\\R +70 ").containsMatchIn("$printed"),
            printed.toString(),
        )
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
            "serve --heap 63 --lang ru",
            "serve --host no.such.host.invalid --lang ru",
            "serve --exam --exam --lang ru",
            "serve --more --lang ru",
            "serve more --lang ru",
            "serve --port 0 --db h2:x --lang ru",
            "serve --port 0 --db sqlite:?x --lang ru",
            "serve --port 0 --db sqlite:FOLDER --lang ru",
            "serve --port 0 --db sqlite:FOLDER/none/a --lang ru",
            "serve --port 0 --db sqlite:TWICE --lang ru",
            "serve --port 0 --data FILE --lang ru",
            "serve --port 0 --data FILE/below --lang ru",
            "serve --port 0 --data USED --lang ru",
            "serve --port 0 --data UNWRITTEN --lang ru",
            "serve --port TAKEN --lang ru",
            "serve --port 0 --host 192.0.2.1 --lang ru",
            "serve --port 0 --exercises FOLDER/none --lang ru",
            "serve --port 0 --exercises FILE --lang ru",
            "serve --port 0 --exercises FOLDER --lang ru",
            "serve --port 0 --proxy localhost --lang ru",
            "serve --config FOLDER/none.yaml --lang ru",
            "serve --config SETTINGS --lang ru",
            "serve --name -a --lang ru",
            "worker --lang ru",
            "worker --db sqlite:FOLDER/w --lang ru",
            "backup --lang ru",
            "backup FOLDER --data FOLDER --lang ru",
            "backup FOLDER/b --data FOLDER/none --lang ru",
            "restore FOLDER/b --data FOLDER/new --lang ru",
            "token --data FOLDER/none --lang ru",
            "student --lang ru",
            "student export x --as zip --data FOLDER --lang ru",
            "student export x --as doc --data FOLDER --lang ru",
            "student delete --lang ru",
            "export x --to FILE --data FOLDER --lang ru",
            "help nope --lang ru",
            "nope --lang ru",
            "serve --port 0 --exercises BROKEN --lang ru",
        ],
    )
    fun `complaints are Russian`(call: String) {
        val file = folder.resolve("a").createFile()
        folder
            .resolve("broken/my-line")
            .createDirectories()
            .resolve("exercise.json")
            .writeText("{} []")
        val used = folder.resolve("used")
        val twice = folder.resolve("c").createLinkPointingTo(folder.resolve("b").createFile())
        val settings = folder.resolve("s.yaml").apply { writeText("port: 0\nexam: perhaps\n") }
        val unwritten = folder.resolve("unwritten/server.lock").createDirectories().parent
        DataFolder.take(used, url = null).use {
            ServerSocket(0, 1, InetAddress.getByName("127.0.0.1")).use { taken ->
                val words =
                    call
                        .replace("FOLDER", "$folder")
                        .replace("FILE", "$file")
                        .replace("SETTINGS", "$settings")
                        .replace("BROKEN", "$folder/broken")
                        .replace("UNWRITTEN", "$unwritten")
                        .replace("USED", "$used")
                        .replace("TWICE", "$twice")
                        .replace("TAKEN", "${taken.localPort}")
                assertEquals(2, run(*words.split(" ").toTypedArray()), printed.toString())
            }
        }
        assertRussian()
        assertEquals(1, printed.lines().size, printed.toString())
    }

    @ParameterizedTest(name = "{0} for a command is called an argument, or those there are stay unnamed")
    @ValueSource(strings = ["nope", "nope --lang ru", "help nope --lang ru"])
    fun `an unknown command is answered with those there are`(call: String) {
        assertEquals(2, run(*call.split(" ").toTypedArray()))
        val said = printed.toString()
        assertTrue(Regex("no command 'nope'|нет команды «nope»").containsMatchIn(said), said)
        assertTrue(
            said.trim().endsWith(
                "serve, worker, backup, restore, token, course, student, export, staff, regrade, lti, help",
            ),
            said,
        )
    }

    @ParameterizedTest(name = "help of {0} is the help of the command above it")
    @ValueSource(strings = ["course roster", "staff add", "regrade start", "serve"])
    fun `help reaches the commands below`(names: String) {
        val parts = names.split(" ")
        for (language in listOf("en", "ru")) {
            val help = answer(parts + listOf("--help", "--lang", language))
            for (at in parts.indices) {
                assertEquals(help, answer(parts.take(at) + "help" + parts.drop(at) + listOf("--lang", language)))
            }
        }
    }

    private fun answer(words: List<String>): String {
        printed.buffer.setLength(0)
        assertEquals(0, run(*words.toTypedArray()), printed.toString())
        return printed.toString()
    }

    @ParameterizedTest(name = "the help of {0} in Russian breaks a line that was broken already")
    @ValueSource(strings = ["--help", "serve --help", "worker --help", "backup --help", "token --help"])
    fun `no line of the help holds one word alone`(call: String) {
        assertEquals(0, run(*"$call --lang ru".split(" ").toTypedArray()))
        val alone = printed.toString().lines().filter { Regex(" {12,}\\S+").matches(it) }
        assertEquals(emptyList<String>(), alone, printed.toString())
    }

    @Test
    fun `a database of another program is refused in English`() {
        val notes = folder.resolve("notes.db").apply { writeText("not a database ".repeat(100)) }
        val refused = assertThrows(CannotStart::class.java) { openDatabase(SqliteFile(notes), folder) }
        assertRussian(refused.said(RUSSIAN))
    }

    @Test
    fun `a word in the language of who starts is written to the log`() {
        val isolation = Message.of("isolation.plain")
        val refused = CannotStart(StartFailure.EXAM, isolation)
        assertTrue(refused.message.startsWith("--exam: the server does not start, because layers"), refused.message)
        assertTrue(refused.message.endsWith(": ${isolation.`in`("en")}"), refused.message)
        assertTrue(refused.said(RUSSIAN).endsWith(": ${isolation.`in`("ru")}"), refused.said(RUSSIAN))
        assertRussian(refused.said(RUSSIAN))
    }

    @Test
    fun `a reason has no words, or words are read by nobody`() {
        assertEquals(StartFailure.entries.map { it.key }.toSet(), keys("storage/reasons.properties"))
    }

    private fun StringWriter.lines() = toString().trim().lines()

    @ParameterizedTest(name = "a text of {0} is missing in one language")
    @ValueSource(strings = ["command", "storage/reasons"])
    fun `each text is there in both languages`(name: String) {
        val english = keys("$name.properties")
        // In English picocli has them itself, or they stand with the commands.
        val others =
            Regex(
                "(\\./lab grader|usage)\\..*|unknown\\.(option|argument)|missing|twice|invalid|" +
                    "lang.*|java-images.*|data.*|(backup|restore)\\.file|token\\.who.*|heap\\.[0-9]|proxy.*|public-address|oidc-.*|sign-in-.*|tls-.*|(entries|submissions)-per-minute.*|waiting.*|config.*|host.*|port|db.*|exam|exercises|workers.*|worker\\..*|process\\.name.*|course\\.(of|file|dry|for|exercises)|rules\\..*|student\\.(id|json|as|yes)|export\\.to|staff\\.(name|id|role|only|course)|lti\\..*|regrade\\.(id|of.*|submission|dry)",
            )
        val russian = keys("${name}_ru.properties").filterNot { name == "command" && others.matches(it) }
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

    private companion object {
        val RUSSIAN: Locale = Locale.forLanguageTag("ru")
    }
}

package rasterlab.grader

import picocli.CommandLine
import picocli.CommandLine.Command
import picocli.CommandLine.Mixin
import picocli.CommandLine.Model.CommandSpec
import picocli.CommandLine.Option
import picocli.CommandLine.ParameterException
import picocli.CommandLine.Parameters
import picocli.CommandLine.Spec
import rasterlab.grader.lti.Platform
import rasterlab.grader.lti.PlatformForm
import rasterlab.grader.lti.Platforms
import rasterlab.grader.lti.ToolKey
import rasterlab.grader.storage.text
import java.time.InstantSource
import java.util.concurrent.Callable

internal fun ltiCommands(words: CommandWords): CommandLine =
    CommandLine(LtiCommand(words))
        .addSubcommand(LtiListCommand())
        .addSubcommand(LtiAddCommand())
        .addSubcommand(LtiRemoveCommand())
        .addSubcommand(LtiKeyCommand())
        .addSubcommand(ServerHelpCommand(words))

/** Works on the learning platforms that a server trusts, on its machine; the server may run meanwhile. */
@Command(
    name = "lti",
    mixinStandardHelpOptions = true,
    description = [
        "Lists, adds and removes learning platforms that send people here by LTI 1.3, and changes the key for them.",
    ],
)
private class LtiCommand(
    private val words: CommandWords,
) : Runnable {
    @Spec
    lateinit var spec: CommandSpec

    override fun run(): Unit = throw ParameterException(spec.commandLine(), words.say("command"))
}

/** The platforms of the server that is meant. */
internal class PlatformOptions {
    @Mixin
    lateinit var of: DataOptions

    fun <T> open(work: (Platforms) -> T): T = of.open().use { work(Platforms(it, InstantSource.system())) }

    fun <T> openKey(work: (ToolKey) -> T): T = of.open().use { work(ToolKey(it, InstantSource.system())) }
}

/** The lines are the same in every language, for programs. */
private fun CommandSpec.print(one: Platform) =
    commandLine().out.println("${one.id}\t${one.issuer}\t${one.clientId}\t${one.deployment}\t${one.name}")

@Command(
    name = "list",
    mixinStandardHelpOptions = true,
    description = ["Prints id, issuer, client id, deployment and name of each platform, a line for each."],
)
private class LtiListCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: PlatformOptions

    override fun call(): Int =
        of.open { platforms ->
            platforms.all().forEach(spec::print)
            0
        }
}

@Command(
    name = "add",
    mixinStandardHelpOptions = true,
    description = ["Adds a platform, and prints it as list does."],
)
private class LtiAddCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: PlatformOptions

    @Parameters(paramLabel = "NAME", descriptionKey = "lti.name", description = ["What people here call it."])
    lateinit var name: String

    @Option(
        names = ["--issuer"],
        paramLabel = "URL",
        required = true,
        descriptionKey = "lti.issuer",
        description = ["What the platform calls itself (platform ID)."],
    )
    lateinit var issuer: String

    @Option(
        names = ["--client-id"],
        paramLabel = "ID",
        required = true,
        descriptionKey = "lti.client",
        description = ["What the platform calls this server."],
    )
    lateinit var clientId: String

    @Option(
        names = ["--deployment"],
        paramLabel = "ID",
        required = true,
        descriptionKey = "lti.deployment",
        description = ["What the platform calls this place of it (deployment ID)."],
    )
    lateinit var deployment: String

    @Option(
        names = ["--login-url"],
        paramLabel = "URL",
        required = true,
        descriptionKey = "lti.login",
        description = ["Where people are signed in there (authentication request URL)."],
    )
    lateinit var login: String

    @Option(
        names = ["--token-url"],
        paramLabel = "URL",
        required = true,
        descriptionKey = "lti.token",
        description = ["Where the leave to send scores is given (access token URL)."],
    )
    lateinit var token: String

    @Option(
        names = ["--keys-url"],
        paramLabel = "URL",
        required = true,
        descriptionKey = "lti.keys",
        description = ["Where the platform's public keys are (public keyset URL)."],
    )
    lateinit var keys: String

    @Option(
        names = ["--makes-staff"],
        descriptionKey = "lti.staff",
        description = [
            "Makes whoever teaches there an instructor or assistant of this whole server, unasked;",
            "otherwise they show once who they are by their token.",
        ],
    )
    var makesStaff = false

    override fun call(): Int =
        of.open { platforms ->
            val form = PlatformForm(name, issuer, clientId, deployment, login, token, keys, makesStaff)
            spec.print(platforms.add(form, by = "command", key = null))
            0
        }
}

@Command(
    name = "remove",
    mixinStandardHelpOptions = true,
    description = ["Removes a platform. Its students and their work stay; scores are not sent there any more."],
)
private class LtiRemoveCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: PlatformOptions

    @Parameters(paramLabel = "ID", descriptionKey = "lti.id", description = ["The id, as list prints it."])
    lateinit var id: String

    override fun call(): Int =
        of.open { platforms ->
            spec.print(platforms.remove(id, by = "command"))
            0
        }
}

@Command(
    name = "key",
    mixinStandardHelpOptions = true,
    description = [
        "Prints the ids of this server's keys as platforms read them.",
        "The first signs; each one before has the moment until which it is read.",
    ],
)
private class LtiKeyCommand : Callable<Int> {
    @Spec
    lateinit var spec: CommandSpec

    @Mixin
    lateinit var of: PlatformOptions

    @Option(
        names = ["--new"],
        descriptionKey = "lti.new",
        description = ["Makes a new key first. Platforms fetch it by themselves; the one before is read for an hour."],
    )
    var new = false

    override fun call(): Int =
        of.openKey { key ->
            if (new) key.renew(by = "command", key = null)
            key.published().forEach { one ->
                spec.commandLine().out.println(listOfNotNull(one.id, one.until?.text()).joinToString("\t"))
            }
            0
        }
}

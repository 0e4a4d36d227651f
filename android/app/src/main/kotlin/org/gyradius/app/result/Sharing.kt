package org.gyradius.app.result

import android.content.ClipData
import android.content.Context
import android.content.Intent
import android.net.Uri
import android.print.PrintAttributes
import android.print.PrintManager
import android.webkit.WebView
import android.webkit.WebViewClient
import androidx.core.content.FileProvider
import java.io.File
import org.gyradius.app.R

/** Offers a file of the shared folder to the apps that take its type. */
fun shareFile(context: Context, file: File, type: String) {
    val uri = FileProvider.getUriForFile(context, "${context.packageName}.files", file)
    context.startActivity(Intent.createChooser(shareIntent(uri, type), null))
}

/** Read by whoever is chosen, and by nobody else. */
private fun shareIntent(uri: Uri, type: String): Intent = Intent(Intent.ACTION_SEND).apply {
    this.type = type
    putExtra(Intent.EXTRA_STREAM, uri)
    clipData = ClipData.newRawUri(null, uri)
    addFlags(Intent.FLAG_GRANT_READ_URI_PERMISSION)
}

/** Prints a report, or saves it as PDF: Android asks which. The answer must live until its page is laid out. */
fun printReport(context: Context, report: File): WebView {
    val name = context.getString(R.string.report)
    return WebView(context).apply {
        webViewClient = object : WebViewClient() {
            override fun onPageFinished(view: WebView, url: String) {
                val printer = context.getSystemService(PrintManager::class.java) ?: return
                printer.print(name, view.createPrintDocumentAdapter(name), PrintAttributes.Builder().build())
            }
        }
        loadDataWithBaseURL(null, report.readText(), "text/html", "utf-8", null)
    }
}

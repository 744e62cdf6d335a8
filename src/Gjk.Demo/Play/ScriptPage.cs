using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Net;
using System.Reflection;
using System.Security.Cryptography;
using System.Text;

namespace Gjk.Demo.Play;

/// <summary>
/// Writes one self-contained page that runs the library. Its content security policy allows exactly the scripts and the
/// style that are in it, by their hashes, and WebAssembly. It allows no request at all.
/// </summary>
internal static class ScriptPage
{
    private static readonly string[] Assets = ["play.css", "play.js", "three.LICENSE.txt"];

    /// <param name="stream">Where to write.</param>
    /// <param name="title">Shown as plain text.</param>
    /// <param name="json">The data that the page shows.</param>
    public static void Write(Stream stream, string title, ReadOnlySpan<byte> json)
    {
        string style = Asset(Assets[0]);
        List<string> scripts = [.. BrowserRuntime.Scripts(), Asset(Assets[1])];
        string policy = $"default-src 'none'; script-src {string.Join(" ", scripts.Select(Hash))} 'wasm-unsafe-eval'; "
            + $"style-src {Hash(style)}; img-src data:";
        Add(stream, $"""
            <!doctype html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <meta http-equiv="Content-Security-Policy" content="{policy}">
            <link rel="icon" href="data:,">
            <title>{WebUtility.HtmlEncode(title)}</title>
            <style>{style}</style>
            </head>
            <body>
            <noscript>This page runs the library in a script, which the browser does not run.</noscript>
            <script type="application/json" id="data">
            """.ReplaceLineEndings("\n"));
        stream.Write(json);
        Add(stream, "</script>\n<script type=\"application/json\" id=\"runtime\">");
        stream.Write(BrowserRuntime.Files());
        string notices = BrowserRuntime.Notices() + "\n" + Asset(Assets[2]);
        Add(stream, $"</script>\n<template id=\"notices\">{WebUtility.HtmlEncode(notices)}</template>\n");
        foreach (string script in scripts) Add(stream, $"<script type=\"module\">{script}</script>\n");
        Add(stream, "</body>\n</html>\n");
        stream.Flush();
    }

    private static string Hash(string text) =>
        $"'sha256-{Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes(text)))}'";

    public static string Asset(string name)
    {
        using Stream asset = Assembly.GetExecutingAssembly().GetManifestResourceStream(name)
            ?? throw new InvalidOperationException($"The demo was built without {name}.");
        using var reader = new StreamReader(asset, Encoding.UTF8);
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }

    private static void Add(Stream stream, string text) => stream.Write(Encoding.UTF8.GetBytes(text));
}
